#ifndef continua_finite_element_solvers_iterative_iterative_step_solver_h
#define continua_finite_element_solvers_iterative_iterative_step_solver_h

#include <continua/base/memory_use.h>
#include <continua/continuum/system_coefficients.h>
#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/products/region_operators.h>
#include <continua/finite_element/solvers/iterative/grad_div_preconditioner.h>
#include <continua/finite_element/solvers/iterative/preconditioner_maker.h>
#include <continua/finite_element/solvers/iterative/step_blocks.h>
#include <continua/finite_element/solvers/iterative/step_preconditioner.h>
#include <continua/finite_element/solvers/stalled_block.h>
#include <continua/finite_element/space/linear_solver_parameters.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/saddle_point_solver.h>

#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// FGMRES on a step's system, with a preconditioner that knows its physics (see
/// PreconditionerMaker). The preconditioner is kept as long as it serves.
template <int dim>
class IterativeStepSolver
{
public:
  /// All must outlive it.
  IterativeStepSolver(const Space<dim> &space,
                      const std::vector<RegionOperators> &operators,
                      const BoundaryConstraints<dim> &constraints,
                      const LinearSolverParameters &parameters,
                      MemoryUse *memory_use = nullptr);

  /**
   * Assembles the blocks of new coefficients. The preconditioner is made anew if there is none yet,
   * if a coefficient has changed by more than a factor of two since it was made, or if a solve has
   * taken more than 1.5 times as many iterations as its first one, and 5. Returns whether it was.
   */
  bool prepare(const SystemCoefficients &coefficients);
  /// Solves to the tolerance from the last solution. Throws RunError if that takes too many
  /// iterations. Returns how many it took.
  unsigned int solve(const DistributedVector &momentum,
                     const DistributedVector &mass,
                     DistributedVector &velocity,
                     DistributedVector &pressure);

  /// Gives the preconditioner a part of int gamma div v div u, which is among what a tangent has
  /// beside the linear terms: where the fluid is relaxed by products without a matrix, and with the
  /// mass form of the Schur complement. A change below `smallest_change` is left out.
  /// `viscosities`: the mean gamma in each cell, by active_cell_index() [Pa s]; empty: nothing is
  /// done. Not before prepare(). Collective.
  void precondition_grad_div(const std::vector<double> &viscosities);
  /// The same for a tangent, whose product is given (see SaddlePointSolver::Blocks): from zero,
  /// until the residual is below `tolerance` times that at the start. `kind`: for the message.
  /// Throws StepFailure if that takes too many iterations.
  unsigned int solve_tangent(const SaddlePointSolver::Product &tangent_product,
                             TangentTerms kind,
                             double tolerance,
                             const DistributedVector &momentum,
                             const DistributedVector &mass,
                             DistributedVector &velocity,
                             DistributedVector &pressure);

  /// See SaddlePointSolver.
  void free_basis() { solver.free_basis(); }

  /// "FGMRES; stiff block: ..., fluid block: ..., Schur complement: ...".
  std::string name() const;
  /// Of the stiff block; null if it has none.
  const SymmetricFactor *factor() const;
  /// Whether some velocities are not in the stiff block, after prepare().
  bool has_fluid_block() const { return preconditioner->has_fluid; }

private:
  const Space<dim> &space;
  const BoundaryConstraints<dim> &constraints;
  const LinearSolverParameters parameters;
  MemoryUse *const memory_use;
  SystemCoefficients coefficients;
  StepBlocks<dim> blocks; ///< of the present coefficients
  PreconditionerMaker<dim> preconditioner_maker;
  std::unique_ptr<StepPreconditioner<dim>> preconditioner;
  GradDivPreconditioner<dim> grad_div;
  SaddlePointSolver solver;
  DistributedVector last_velocity, last_pressure;

  bool is_near(const SystemCoefficients &others) const;
  void make_preconditioner();
  /// From the last solution, or from zero for a correction; once more with a new preconditioner if
  /// it was one of other coefficients that failed. The report counts the iterations of both.
  KrylovReport solve_by_krylov(const SaddlePointSolver::Blocks &system,
                               double tolerance,
                               bool is_correction,
                               const DistributedVector &momentum,
                               const DistributedVector &mass,
                               DistributedVector &velocity,
                               DistributedVector &pressure);
  /// See describe_convergence_failure(); frees the basis before.
  std::string describe_failure(const SaddlePointSolver::Blocks &system,
                               TangentTerms kind,
                               const KrylovReport &report);
  /// Of a solve that has converged: whether the preconditioner is worn.
  void record_use(unsigned int iterations);
};
} // namespace Continua

#endif
