#ifndef continua_finite_element_solvers_iterative_preconditioner_maker_h
#define continua_finite_element_solvers_iterative_preconditioner_maker_h

#include <continua/base/memory_use.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/iterative/preconditioner_plan.h>
#include <continua/finite_element/solvers/iterative/step_blocks.h>
#include <continua/finite_element/solvers/iterative/step_preconditioner.h>
#include <continua/finite_element/solvers/iterative/stiff_factor_limit.h>
#include <continua/finite_element/solvers/iterative/stiff_regions.h>
#include <continua/finite_element/solvers/iterative/velocity_inverse_maker.h>
#include <continua/finite_element/space/linear_solver_parameters.h>
#include <continua/finite_element/space/space.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * Makes the preconditioner of a step's system.
 *
 * The velocities of stiff regions (see StiffRegions) are one block of the VelocityPreconditioner;
 * the others are relaxed, or, where they are viscous on the scale of the mesh, have algebraic
 * multigrid of their own.
 *
 * With multigrid on the stiff block, and with the Schur complement of SIMPLE, the pressures of the
 * stiff regions stay in the Schur complement. With multigrid the preconditioner there has the
 * system augmented by the bulk modulus alpha (see SaddlePointSolver). PolynomialMultigrid takes its
 * B^T W B as it is, algebraic multigrid int alpha div u div v in its place. An error in the
 * pressure's Schur complement S^-1 = (1 + alpha s)/(s + 1/(K b)) then is at most a factor of two
 * for every s >= 1/alpha.
 */
template <int dim>
class PreconditionerMaker
{
public:
  /// All but the parameters must outlive it. `memory_use` may be null.
  PreconditionerMaker(const Space<dim> &space,
                      const std::vector<RegionOperators> &operators,
                      const BoundaryConstraints<dim> &constraints,
                      const LinearSolverParameters &parameters,
                      const StepBlocks<dim> &blocks,
                      MemoryUse *memory_use);

  /// Of the coefficients, which are those of the blocks; with multigrid where the factor of the
  /// stiff block turns out too large. Collective.
  std::unique_ptr<StepPreconditioner<dim>> make(const SystemCoefficients &coefficients);

private:
  static constexpr double viscous_ratio = 100.;

  const Space<dim> &space;
  const std::vector<RegionOperators> &operators;
  const BoundaryConstraints<dim> &constraints;
  const LinearSolverParameters parameters;
  const StepBlocks<dim> &blocks;
  MemoryUse *const memory_use;
  StiffFactorLimit<dim> limit;
  VelocityInverseMaker<dim> velocity_inverse_maker;

  bool is_simple() const { return parameters.schur_complement == SchurApproximation::simple; }
  /// Throws FactorTooLarge.
  std::unique_ptr<StepPreconditioner<dim>> try_to_make(const SystemCoefficients &coefficients);
  /// Decides on the blocks, and tells the preconditioner what it knows of them. Throws
  /// FactorTooLarge.
  PreconditionerPlan choose_blocks(const StiffRegions<dim> &stiff_regions,
                                   StepPreconditioner<dim> &made);
  /// Whether the velocities outside the stiff block are relaxed by products without a matrix.
  bool can_relax_without_matrix(const StiffRegions<dim> &stiff_regions,
                                const SystemCoefficients &coefficients) const;
  /// Sets the augmentation W, and the factors of the regions in the mass form [1/(Pa s)].
  void augment(const StiffRegions<dim> &stiff_regions,
               const PreconditionerPlan &plan,
               std::vector<double> &mass_factors,
               StepPreconditioner<dim> &made) const;
  void make_schur_complement(PreconditionerPlan &plan,
                             const std::vector<double> &mass_factors,
                             StepPreconditioner<dim> &made) const;
  /// "FGMRES; stiff block: ..., fluid block: ..., Schur complement: ...".
  std::string name_of(const PreconditionerPlan &plan, const StepPreconditioner<dim> &made) const;
  void mark_memory(const std::string &part) const;
};
} // namespace Continua

#endif
