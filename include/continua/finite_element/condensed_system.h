#ifndef continua_finite_element_condensed_system_h
#define continua_finite_element_condensed_system_h

#include <continua/continuum/system_coefficients.h>
#include <continua/finite_element/boundary_constraints.h>
#include <continua/finite_element/region_operators.h>
#include <continua/finite_element/space.h>
#include <continua/linear_algebra/symmetric_factor.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace Continua
{
/**
 * The blocks of a step's matrix with the boundary constraints eliminated on both sides, T^T A T, B
 * T and C, distributed by rows. Rows of constrained and hanging unknowns have a one on the diagonal
 * of A and C, and nothing else.
 */
struct CondensedBlocks
{
  dealii::TrilinosWrappers::SparseMatrix velocity;    ///< A [kg/s]
  dealii::TrilinosWrappers::SparseMatrix divergence;  ///< B, rows: pressure [m^(dim-1)]
  dealii::TrilinosWrappers::SparseMatrix compression; ///< C [m^3/(Pa s)]
};

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

/// `volumetric` is added to A; may be null.
template <int dim>
void assemble_condensed_blocks(const Space<dim> &space,
                               const std::vector<RegionOperators> &operators,
                               const BoundaryConstraints<dim> &constraints,
                               const SystemCoefficients &coefficients,
                               const VolumetricStiffness *volumetric,
                               CondensedBlocks &blocks);

/// The sum of the regions' pressure masses with a factor each; a one for hanging nodes.
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
