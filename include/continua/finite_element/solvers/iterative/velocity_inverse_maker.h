#ifndef continua_finite_element_solvers_iterative_velocity_inverse_maker_h
#define continua_finite_element_solvers_iterative_velocity_inverse_maker_h

#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/matrix_free_product.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/condensed_system.h>
#include <continua/finite_element/solvers/iterative/preconditioner_plan.h>
#include <continua/finite_element/solvers/iterative/step_blocks.h>
#include <continua/finite_element/solvers/iterative/step_preconditioner.h>
#include <continua/finite_element/solvers/iterative/stiff_factor_limit.h>
#include <continua/finite_element/solvers/iterative/stiff_regions.h>
#include <continua/finite_element/space/linear_solver_parameters.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/velocity_cycle.h>
#include <continua/linear_algebra/velocity_relaxation.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * Makes the approximate inverse of A, augmented or not, of a preconditioner: the factor or the
 * multigrid of the stiff block and the relaxation or the multigrid of the fluid.
 *
 * A alone takes no work for a change of volume; thin walls have many motions whose only work that
 * is. A direct stiff block therefore contains the pressures of the stiff regions, too. Where they
 * are incompressible it has a bulk modulus of 1e3 alpha instead, since its factor does not pivot.
 */
template <int dim>
class VelocityInverseMaker
{
public:
  /// All but the parameters must outlive it.
  VelocityInverseMaker(const Space<dim> &space,
                       const std::vector<RegionOperators> &operators,
                       const BoundaryConstraints<dim> &constraints,
                       const LinearSolverParameters &parameters,
                       const StepBlocks<dim> &blocks,
                       StiffFactorLimit<dim> &limit);

  /// Gives a preconditioner, of which the rest is known, the inverse of its velocities. Throws
  /// FactorTooLarge. Collective.
  void make(const StiffRegions<dim> &stiff_regions,
            const PreconditionerPlan &plan,
            StepPreconditioner<dim> &made);

private:
  /// Of the stiff block: 1/(K b) is at least so many 1/alpha.
  static constexpr double least_compressibility = 1e-3;

  const Space<dim> &space;
  const std::vector<RegionOperators> &operators;
  const BoundaryConstraints<dim> &constraints;
  const LinearSolverParameters parameters;
  const StepBlocks<dim> &blocks;
  StiffFactorLimit<dim> &limit;
  std::unique_ptr<MatrixFreeProduct<dim, float>> single_precision_product;

  /// Of the augmentation by a bulk modulus of alpha, in the stiff regions that have it.
  VolumetricStiffness volumetric_stiffness(const StiffRegions<dim> &stiff_regions,
                                           const PreconditionerPlan &plan,
                                           const SystemCoefficients &coefficients) const;
  std::unique_ptr<VelocityRelaxation> make_relaxation(const PreconditionerPlan &plan,
                                                      const std::vector<double> &volumetric,
                                                      StepPreconditioner<dim> &made);
  /// With a factor of the stiff velocities and pressures. `has_matrix`: the preconditioner has the
  /// rows of A, else the block alone gets their entries.
  void make_joint_block(const StiffRegions<dim> &stiff_regions,
                        const PreconditionerPlan &plan,
                        bool has_matrix,
                        bool needs_all_rows,
                        std::unique_ptr<VelocityRelaxation> relaxation,
                        StepPreconditioner<dim> &made);
  std::unique_ptr<VelocityCycle>
  make_polynomial_multigrid(StepPreconditioner<dim> &made,
                            const std::vector<double> &volumetric,
                            const dealii::TrilinosWrappers::SparseMatrix &divergence_matrix);
  /// The preconditioners' products share its cells. Made once.
  const MatrixFreeProduct<dim, float> &single_precision_cells();
};
} // namespace Continua

#endif
