#ifndef continua_finite_element_solvers_condensed_system_h
#define continua_finite_element_solvers_condensed_system_h

#include <continua/continuum/system_coefficients.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace Continua
{
/// int div u div v of each region that has a coefficient [Pa s]: a bulk stiffness beside the shear
/// stiffness alpha.
struct VolumetricStiffness
{
  std::vector<double> coefficients;
  std::vector<dealii::TrilinosWrappers::SparseMatrix> matrices;
};

/// Makes the matrices, with the hanging nodes condensed.
template <int dim>
void assemble_volumetric_stiffness(const Space<dim> &space,
                                   const std::vector<RegionOperators> &operators,
                                   VolumetricStiffness &volumetric);

// Blocks of a step's matrix with the boundary constraints eliminated on both sides, distributed by
// rows.

/**
 * T^T A T [kg/s], with a one on the diagonal of constrained and hanging velocities and nothing else
 * in their rows. `volumetric` is added; may be null. `rows`: which of the owned rows there are, by
 * local index, others stay empty; null means all of them.
 */
template <int dim>
void assemble_velocity_block(const Space<dim> &space,
                             const std::vector<RegionOperators> &operators,
                             const BoundaryConstraints<dim> &constraints,
                             const SystemCoefficients &coefficients,
                             const VolumetricStiffness *volumetric,
                             const std::vector<bool> *rows,
                             dealii::TrilinosWrappers::SparseMatrix &matrix);

/// B T, rows: pressure [m^(dim-1)].
template <int dim>
void assemble_divergence(const Space<dim> &space,
                         const std::vector<RegionOperators> &operators,
                         const BoundaryConstraints<dim> &constraints,
                         dealii::TrilinosWrappers::SparseMatrix &matrix);

/// The sum of the regions' pressure masses with a factor each, as C with 1/(K b) [m^3/(Pa s)]; a
/// one for hanging nodes.
template <int dim>
void assemble_pressure_mass(const Space<dim> &space,
                            const std::vector<RegionOperators> &operators,
                            const std::vector<double> &factors,
                            dealii::TrilinosWrappers::SparseMatrix &matrix);

/// The lower triangle of the same as one symmetric indefinite matrix, [A -B^T; -B -C]; velocities
/// come first.
template <int dim>
SymmetricTriplets condensed_triplets(const Space<dim> &space,
                                     const std::vector<RegionOperators> &operators,
                                     const BoundaryConstraints<dim> &constraints,
                                     const SystemCoefficients &coefficients);
} // namespace Continua

#endif
