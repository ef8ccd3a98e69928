#ifndef continua_finite_element_solvers_loaded_cells_h
#define continua_finite_element_solvers_loaded_cells_h

#include <continua/continuum/problem.h>
#include <continua/finite_element/assembly/metric_history.h>
#include <continua/finite_element/assembly/nonlinear_cell_terms.h>
#include <continua/finite_element/space/quadrature_cells.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/linear_algebra/unsymmetric_factor.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Continua
{
/// A state at rest under loads; owned entries.
struct LoadedState
{
  DistributedVector displacement, velocity, pressure; ///< [m], [m/s], [Pa]
  DistributedVector mesh_displacement;                ///< of a mesh that moves, else empty [m]
  double time_of_loads = 0.;                          ///< [s]
};

/// What a motion exp(s t) about such a state multiplies by 1, by s^2, by s and by the modulus of
/// the branches, see LoadedBody.
enum class LoadedPart
{
  stiffness,
  mass,
  viscosity,
  relaxation
};

/// One matrix a part. Velocities come first in the stiffness, and its rows of volume are multiplied
/// by -1; the others have velocities alone, or are empty. Between velocities stiffness [N/m], mass
/// [kg], viscosity [N s/m] and relaxation, which is that of the branches over their modulus [m].
template <int dim>
// NOLINTNEXTLINE(bugprone-exception-escape): deal.II's matrix may throw when it is moved
struct LoadedCell
{
  const QuadratureCell<dim> *at = nullptr;
  dealii::FullMatrix<double> stiffness, mass, viscosity, relaxation;
};

/// Values at the points of a face at which its loads are integrated.
template <int dim>
dealii::FEFaceValues<dim> face_values_under_load(const Space<dim> &space);

/// The derivative of the equations of a body at rest under loads by displacement and pressure, cell
/// by cell and in its parts: those of a motion are made of steps in which all but one part is
/// nothing.
template <int dim>
class LoadedCells
{
public:
  /// All but the state must outlive it. `metrics`: null where nothing relaxes. Collective. Throws
  /// RunError if a liquid flows, or its pressure is not uniform.
  LoadedCells(const Space<dim> &space,
              const Problem &problem,
              const NonlinearTerms<dim> &terms,
              MetricHistory<dim> *metrics,
              const LoadedState &state);

  const std::vector<LoadedCell<dim>> &all() const { return cells; }
  static const dealii::FullMatrix<double> &matrix_of(LoadedPart part, const LoadedCell<dim> &cell);
  /// The smallest diameter of a cell [m].
  double smallest() const { return smallest_cell; }
  /// Adds the entries of a part in one region, as NonlinearCellTerms::add_derivative() has them.
  void add_entries(LoadedPart part,
                   unsigned int region,
                   const dealii::AffineConstraints<double> &constraints,
                   Triplets &entries) const;
  /// Of the mesh, which in solids is that of the matter, with ghost entries [m].
  const DistributedVector &shape() const { return displacement; }

private:
  using Matrix = dealii::FullMatrix<double>;
  using Cell = LoadedCell<dim>;

  const Space<dim> &space;
  const Problem &problem;
  std::vector<Cell> cells;
  double smallest_cell = 0.;
  std::vector<double> liquid_pressures; ///< by region, of solids 0 [Pa]
  DistributedVector displacement;       ///< see shape()

  void take_parts(const NonlinearTerms<dim> &terms,
                  MetricHistory<dim> *metrics,
                  const LoadedState &loaded);
  void take_liquid_pressures(const LoadedState &loaded);
  /// `largest_pressure` [Pa]: of the liquids, see take_liquid_pressures().
  void refuse_streams(const DistributedVector &of_state, double largest_pressure) const;
  /// To each solid the pressure of the liquids on its faces, which follows them.
  void add_pressures_of_liquids();
};
} // namespace Continua

#endif
