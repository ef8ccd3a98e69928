#ifndef continua_finite_volume_cell_wise_operators_h
#define continua_finite_volume_cell_wise_operators_h

#include <continua/continuum/problem.h>
#include <continua/finite_volume/cell_wise_parameters.h>
#include <continua/finite_volume/face_conditions.h>
#include <continua/finite_volume/face_traction.h>
#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace Continua
{
/**
 * The operators of one region, free of time step and moduli. Their rows are the equations of the
 * values: of a cell its momentum, of a face with its own value the balance of the tractions on its
 * sides. A face is thus a cell without mass, and what a scheme says of powers holds for both.
 */
struct CellWiseOperators
{
  using Matrix = dealii::TrilinosWrappers::SparseMatrix;
  /// Volumes at the velocities of the region's cells, zero elsewhere [m^3].
  DistributedVector volume;
  /// S: minus the force on a cell and the traction force on a face by the mixture w = eta U + sum
  /// mu_k D_k [N for Pa m].
  Matrix stiffness;
  /// The same on the wide stencil throughout; only where it is asked for.
  Matrix wide_stiffness;
  /// G: the integral of grad p over a cell; -p n on a face [N for Pa].
  Matrix gradient;
  /// B: the integral of div U over a cell, sum over faces of area n.U; on boundary faces whose
  /// pressure follows from its definition the divergence there, times pressure_volume [m^3/s].
  Matrix divergence;
  /// The weights of the equations of state that go with it: a cell's volume, of such a face its
  /// area times its distance from the cell's centre [m^3].
  DistributedVector pressure_volume;
};

/// What the pressures of faces obey that have no equation of state: rows of p_face - (what the
/// cells say); of other pressures no entries. The same for all regions.
struct PressureClosure
{
  /// Of the faces of one region.
  struct Part
  {
    struct Entry
    {
      unsigned int row, column; ///< global
      double value;
    };
    std::vector<unsigned int> rows; ///< local indices
    std::vector<Entry> entries;
  };
  dealii::TrilinosWrappers::SparseMatrix matrix;
  std::vector<unsigned int> rows; ///< local indices
  std::vector<Part> parts;        ///< by material id
};

/// The coefficients of a region's traction.
struct TractionCoefficients
{
  double stencil_ratio = 1.; ///< kappa = c/mu
  double trace_ratio = -2. / 3.;
};

/// From the material and what the parameters ask for; 1 where there are no branches. Throws
/// std::invalid_argument if a modulus is infinite.
TractionCoefficients traction_coefficients(const Material &material,
                                           const CellWiseParameters &parameters);

/// Assembles the operators of these regions, by material id; those of the others stay as they are.
template <int dim>
void assemble_cell_operators(const CellWiseSpace<dim> &space,
                             const Problem &problem,
                             const FaceConditions<dim> &conditions,
                             const CellWiseParameters &parameters,
                             const std::vector<bool> &regions,
                             std::vector<CellWiseOperators> &operators,
                             PressureClosure &closure);
} // namespace Continua

#endif
