#ifndef continua_finite_element_solvers_iterative_velocity_rows_h
#define continua_finite_element_solvers_iterative_velocity_rows_h

#include <continua/continuum/system_coefficients.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/condensed_system.h>
#include <continua/finite_element/space/space.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace Continua
{
/// A, with the volumetric stiffness [kg/s], in some rows (by local index); null means all of them.
/// Makes the matrices of `volumetric`, and where the regions have none, theirs for the rows alone.
/// Collective.
template <int dim>
void assemble_velocity_rows(const Space<dim> &space,
                            const std::vector<RegionOperators> &operators,
                            const BoundaryConstraints<dim> &constraints,
                            const SystemCoefficients &coefficients,
                            const std::vector<unsigned int> *wanted,
                            VolumetricStiffness &volumetric,
                            dealii::TrilinosWrappers::SparseMatrix &matrix);
} // namespace Continua

#endif
