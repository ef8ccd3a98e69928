#include <continua/finite_element/solvers/iterative/iterative_step_solver.h>

#include <continua/base/input_error.h>
#include <continua/finite_element/solvers/iterative/convergence_failure.h>

#include <sstream>

namespace Continua
{
template <int dim>
IterativeStepSolver<dim>::IterativeStepSolver(const Space<dim> &space,
                                              const std::vector<RegionOperators> &operators,
                                              const BoundaryConstraints<dim> &constraints,
                                              const LinearSolverParameters &parameters,
                                              MemoryUse *const memory_use)
    : space(space),
      constraints(constraints),
      parameters(parameters),
      memory_use(memory_use),
      blocks(space, operators, constraints, parameters),
      preconditioner_maker(space, operators, constraints, parameters, blocks, memory_use),
      grad_div(space),
      solver(parameters.restart_length),
      last_velocity(space.velocity_vector()),
      last_pressure(space.pressure_vector())
{
}

template <int dim>
bool IterativeStepSolver<dim>::is_near(const SystemCoefficients &others) const
{
  const auto near = [](const std::vector<double> &a, const std::vector<double> &b)
  {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] > 2. * b[i] || b[i] > 2. * a[i])
        return false;
    return true;
  };
  return near(coefficients.mass, others.mass) && near(coefficients.stiffness, others.stiffness) &&
         near(coefficients.compressibility, others.compressibility);
}

template <int dim>
bool IterativeStepSolver<dim>::prepare(const SystemCoefficients &wanted)
{
  coefficients = wanted;
  const bool is_first = !blocks.are_set();
  blocks.set(coefficients);
  solver.reinit(blocks.all());
  if (is_first && memory_use != nullptr)
    memory_use->mark("blocks of the system");
  if (preconditioner && !preconditioner->is_worn && is_near(preconditioner->coefficients))
    return false;
  make_preconditioner();
  return true;
}

template <int dim>
void IterativeStepSolver<dim>::make_preconditioner()
{
  // The old one first: two would not fit where one does.
  preconditioner = nullptr;
  preconditioner = preconditioner_maker.make(coefficients);
  grad_div.add_to(*preconditioner);
}

template <int dim>
void IterativeStepSolver<dim>::precondition_grad_div(const std::vector<double> &viscosities)
{
  if (viscosities.empty() || preconditioner->relaxation == nullptr ||
      parameters.schur_complement == SchurApproximation::simple)
    return;
  if (!grad_div.take(viscosities, *preconditioner))
    return;
  grad_div.add_to(*preconditioner);
  preconditioner->is_used = false; // its iterations count anew
}

template <int dim>
void IterativeStepSolver<dim>::record_use(const unsigned int iterations)
{
  StepPreconditioner<dim> &used = *preconditioner;
  if (!used.is_used)
    used.first_iterations = iterations;
  used.is_used = true;
  used.is_worn =
      !(coefficients == used.coefficients) && iterations > 1.5 * used.first_iterations + 5.;
}

template <int dim>
KrylovReport IterativeStepSolver<dim>::solve_by_krylov(const SaddlePointSolver::Blocks &system,
                                                       const double tolerance,
                                                       const bool is_correction,
                                                       const DistributedVector &momentum,
                                                       const DistributedVector &mass,
                                                       DistributedVector &velocity,
                                                       DistributedVector &pressure)
{
  unsigned int iterations = 0;
  KrylovReport report;
  for (bool last_try = false;; last_try = true)
  {
    if (is_correction)
    {
      velocity = 0.;
      pressure = 0.;
    }
    else
    {
      velocity.equ(1., last_velocity);
      pressure.equ(1., last_pressure);
    }
    report = solver.solve(system, *preconditioner->velocity, *preconditioner->schur_complement,
                          preconditioner->augmentation, momentum, mass, velocity, pressure,
                          tolerance, parameters.maximum_iterations, is_correction);
    iterations += report.iterations;
    if (report.converged || last_try || coefficients == preconditioner->coefficients)
      break;
    make_preconditioner();
  }
  if (report.converged)
    record_use(report.iterations);
  report.iterations = iterations;
  return report;
}

template <int dim>
std::string IterativeStepSolver<dim>::describe_failure(const SaddlePointSolver::Blocks &system,
                                                       const TangentTerms kind,
                                                       const KrylovReport &report)
{
  solver.free_basis();
  return describe_convergence_failure(space, constraints, parameters, system, *preconditioner, kind,
                                      report);
}

template <int dim>
unsigned int IterativeStepSolver<dim>::solve(const DistributedVector &momentum,
                                             const DistributedVector &mass,
                                             DistributedVector &velocity,
                                             DistributedVector &pressure)
{
  const SaddlePointSolver::Blocks system = blocks.all();
  const KrylovReport report =
      solve_by_krylov(system, parameters.tolerance, false, momentum, mass, velocity, pressure);
  if (!report.converged)
  {
    std::ostringstream text;
    text << "the iterative solver has not converged: after " << report.iterations
         << " iterations the residual is " << report.residual
         << " of the largest term of the equations, and Linear solver/Tolerance is "
         << parameters.tolerance << ". " << describe_failure(system, TangentTerms::none, report);
    throw RunError(text.str());
  }
  last_velocity.equ(1., velocity);
  last_pressure.equ(1., pressure);
  return report.iterations;
}

template <int dim>
unsigned int
IterativeStepSolver<dim>::solve_tangent(const SaddlePointSolver::Product &tangent_product,
                                        const TangentTerms kind,
                                        const double tolerance,
                                        const DistributedVector &momentum,
                                        const DistributedVector &mass,
                                        DistributedVector &velocity,
                                        DistributedVector &pressure)
{
  SaddlePointSolver::Blocks tangent = blocks.all();
  tangent.tangent_product = tangent_product;
  const KrylovReport report =
      solve_by_krylov(tangent, tolerance, true, momentum, mass, velocity, pressure);
  if (!report.converged)
  {
    std::ostringstream text;
    text << "the iterative solver has not converged for a correction of Newton's iteration: after "
         << report.iterations << " iterations the residual is " << report.residual
         << " of that at the start, and Newton/Krylov tolerance is " << tolerance << ". "
         << describe_failure(tangent, kind, report);
    throw StepFailure(text.str());
  }
  return report.iterations;
}

template <int dim>
std::string IterativeStepSolver<dim>::name() const
{
  return preconditioner ? preconditioner->name : "FGMRES";
}

template <int dim>
const SymmetricFactor *IterativeStepSolver<dim>::factor() const
{
  return preconditioner ? preconditioner->velocity->factor() : nullptr;
}

template class IterativeStepSolver<2>;
template class IterativeStepSolver<3>;
} // namespace Continua
