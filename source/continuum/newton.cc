#include <continua/continuum/newton.h>

#include <continua/base/input_error.h>
#include <continua/continuum/newton_convergence.h>

#include <string>
#include <vector>

namespace Continua
{
namespace
{
/// Where a residual of volume counts as round-off of a pressure: the part of the volume that it
/// loses in a step.
constexpr double largest_lost_volume = 1e-12;

/// While it lives, wall time counts as that of a factor, not as that of the solve around it.
class FactorTime
{
public:
  explicit FactorTime(SectionTimer &timer) : timer(timer)
  {
    timer.leave_subsection("solve");
    timer.enter_subsection("factor");
  }
  ~FactorTime()
  {
    timer.leave_subsection("factor");
    timer.enter_subsection("solve");
  }
  FactorTime(const FactorTime &) = delete;
  FactorTime &operator=(const FactorTime &) = delete;

private:
  SectionTimer &timer;
};
} // namespace

Newton::Newton(const Problem &problem,
               NonlinearSystem &terms,
               LinearSystem &system,
               const ProductsByRegion &products,
               OutletCoupling &outlets,
               BoundaryPressures &unknown_pressures,
               Log &log)
    : problem(problem),
      terms(terms),
      system(system),
      outlets(outlets),
      unknown_pressures(unknown_pressures),
      log(log),
      residual(problem, terms, system, products, outlets),
      krylov(BlockKrylov::Method::gmres, 3 * problem.newton.most_krylov_iterations)
{
}

void Newton::reinit(const DistributedVector &of_velocity, const DistributedVector &of_pressure)
{
  residual.reinit(of_velocity, of_pressure);
  for (DistributedVector *vector : {&zero_velocity, &velocity_change})
    vector->reinit(of_velocity);
  pressure_change.reinit(of_pressure);
  krylov.use(terms.solves_with_kept_derivative() ? BlockKrylov::Method::fgmres
                                                 : BlockKrylov::Method::gmres);
  krylov.reinit(zero_velocity, pressure_change);
  has_factor = false;
  if (!problem.convection.is_explicit())
    return;
  for (DistributedVector *vector : {&zero_state.velocity, &zero_state.acceleration})
    vector->reinit(zero_velocity);
  for (DistributedVector *vector : {&zero_state.pressure, &zero_state.pressure_rate})
    vector->reinit(pressure_change);
}

void Newton::solve_by_factor(DistributedVector &momentum_rows,
                             DistributedVector &mass_rows,
                             DistributedVector &of_velocity,
                             DistributedVector &of_pressure,
                             StepReport &report)
{
  const bool has_outlets = problem.mesh_moves && !outlets.is_empty();
  const std::vector<double> of_ports =
      has_outlets ? outlets.port_rows(momentum_rows) : std::vector<double>();
  system.solve(zero_velocity, momentum_rows, mass_rows, of_velocity, of_pressure, report);
  if (has_outlets)
    outlets.complete_change(of_ports, of_velocity, of_pressure);
}

bool Newton::solve_by_krylov(const NewtonInput &input,
                             const StepSolution &solution,
                             const ResidualScales &scales,
                             DistributedVector &momentum_rows,
                             DistributedVector &mass_rows,
                             DistributedVector &of_velocity,
                             DistributedVector &of_pressure,
                             StepReport &report)
{
  // Where a residual is zero and stays so, any size does.
  const auto size_of = [](const double scale) { return scale > 0. ? scale : 1.; };
  const double momentum_size = size_of(scales.momentum), mass_size = size_of(scales.mass);
  residual.restrict_rows(momentum_rows, mass_rows);
  krylov.scale.block(0) = 1. / momentum_size;
  krylov.scale.block(1) = 1. / mass_size;
  krylov.set_right_hand_side(momentum_rows, mass_rows);
  const auto product = [&](const DistributedVector &velocity, const DistributedVector &pressure,
                           DistributedVector &of_momentum, DistributedVector &of_mass)
  { residual.set_derivative_product(input, solution, velocity, pressure, of_momentum, of_mass); };
  const auto inverse = [&](DistributedVector &of_momentum, DistributedVector &of_mass,
                           DistributedVector &velocity, DistributedVector &pressure)
  {
    of_momentum *= momentum_size;
    of_mass *= mass_size;
    solve_by_factor(of_momentum, of_mass, velocity, pressure, report);
  };
  const unsigned int most = problem.newton.most_krylov_iterations;
  const unsigned int n_iterations =
      krylov
          .solve(product, inverse, krylov.scaled_right_hand_side().l2_norm(),
                 problem.newton.krylov_tolerance, 3 * most, of_velocity, of_pressure)
          .iterations;
  // Where each solve around it has iterations of its own, these are the ones that are reported.
  if (!terms.solves_with_kept_derivative())
    report.linear_iterations += n_iterations;
  krylov_iterations += n_iterations;
  return n_iterations < 3 * most;
}

bool Newton::correct_by_krylov(const NewtonInput &input,
                               const StepSolution &solution,
                               const ResidualScales &scales,
                               StepReport &report)
{
  const bool has_converged =
      solve_by_krylov(input, solution, scales, residual.momentum, residual.mass, velocity_change,
                      pressure_change, report);
  // All solves of the step together: a new factor serves many steps.
  if (krylov_iterations > problem.newton.most_krylov_iterations)
    factor_is_poor = true;
  // What the unknown pressures of boundaries do is wanted to the same tolerance.
  const double flow = unknown_pressures.largest_flow();
  unknown_pressures.respond(
      [&](DistributedVector &of_momentum, DistributedVector &of_mass, DistributedVector &velocity,
          DistributedVector &pressure)
      {
        solve_by_krylov(input, solution, {of_momentum.linfty_norm(), flow}, of_momentum, of_mass,
                        velocity, pressure, report);
      });
  return has_converged;
}

void Newton::begin_step(const NewtonInput &input, StepSolution &solution)
{
  is_explicit = problem.convection.is_explicit() && !input.step.finds_steady_state;
  if (is_explicit)
  {
    solution.extrapolated_velocity.equ(1., solution.velocity);
    zero_state.step = input.step;
  }
  if (input.system_is_new)
    has_factor = false;
  outlets.predict(input.step, input.velocity_old);
  if (problem.mesh_moves)
    outlets.set_port_velocities(solution.velocity);
  unknown_pressures.begin_step(input.step);
  residual.begin_step(solution.acceleration);
  krylov_iterations = 0;
  takes_krylov = correction_is_exact = false;
  may_take_krylov = !is_explicit &&
                    (problem.mesh_moves || (outlets.is_empty() && unknown_pressures.is_empty() &&
                                            terms.has_derivative_products())) &&
                    problem.newton.slow_iteration == SlowIteration::krylov;
  // The factor leaves out what the mesh's motion does to the liquid, which is much in a long step.
  is_exact_at_once =
      problem.mesh_moves && input.step.finds_steady_state && !input.step.finds_unloaded_shape;
}

void Newton::prepare_correction(const StepSolution &solution,
                                const bool is_slow,
                                const unsigned int iteration,
                                StepReport &report)
{
  correction_is_exact = is_explicit || (terms.solves_with_kept_derivative() && !problem.mesh_moves);
  const bool can_take_krylov = has_factor && !factor_is_poor && may_take_krylov;
  if ((is_slow || is_exact_at_once) && can_take_krylov)
  {
    takes_krylov = true;
    if (!residual.takes_differences())
      terms.keep_derivative(solution);
  }
  else if (is_explicit)
  {
    // Both serve all steps of one size.
    if (!has_factor)
    {
      make_factor(zero_state, iteration, report);
      if (!terms.solves_with_kept_derivative())
        terms.keep_derivative(zero_state);
    }
  }
  else if (is_slow || !has_factor)
    make_factor(solution, iteration, report);
  // On a mesh that moves the derivative that is kept takes the place of a factor.
  else if (terms.solves_with_kept_derivative() && !problem.mesh_moves)
    terms.keep_derivative(solution);
}

void Newton::make_factor(const StepSolution &solution,
                         const unsigned int iteration,
                         StepReport &report)
{
  has_factor = false; // if this fails
  try
  {
    const FactorTime time(log.timer());
    if (terms.linearise(solution))
      ++report.factors;
  }
  catch (const RunError &error)
  {
    // The first iterate is the state itself, which no shorter step changes.
    if (iteration == 0)
      throw;
    throw StepFailure(std::string("Newton's iteration has no tangent after ") +
                      std::to_string(iteration) + " iterations: " + error.what());
  }
  has_factor = correction_is_exact = true;
  factor_is_poor = false;
  takes_krylov = is_exact_at_once && may_take_krylov;
  outlets.respond(report);
  unknown_pressures.respond(
      [&](DistributedVector &of_momentum, DistributedVector &of_mass,
          DistributedVector &of_velocity, DistributedVector &of_pressure)
      { solve_by_factor(of_momentum, of_mass, of_velocity, of_pressure, report); });
}

void Newton::correct(const NewtonInput &input,
                     StepSolution &solution,
                     const ResidualScales &scales,
                     StepReport &report)
{
  if (takes_krylov)
    correction_is_exact = correct_by_krylov(input, solution, scales, report);
  else if (terms.solves_with_kept_derivative() && !problem.mesh_moves)
  {
    // An inexact solve leaves a part of its right-hand side. That is the residual, without the
    // ports' forces it would be much more: their part of the correction is taken out again.
    system.solve(zero_velocity, residual.momentum_work, residual.mass_work, velocity_change,
                 pressure_change, report);
    outlets.add_pressure_responses(-1., velocity_change, pressure_change);
  }
  else
    solve_by_factor(residual.momentum, residual.mass, velocity_change, pressure_change, report);
  unknown_pressures.couple(input.step, velocity_change, pressure_change,
                           solution.boundary_pressures);
  solution.velocity.add(1., velocity_change);
  solution.pressure.add(1., pressure_change);
  if (!problem.mesh_moves)
    outlets.couple(input.step, input.velocity_old, solution.velocity, solution.pressure);
}

void Newton::solve(const NewtonInput &input, StepSolution &solution, StepReport &report)
{
  begin_step(input, solution);
  NewtonConvergence convergence(problem.newton);
  for (unsigned int iteration = 0;; ++iteration)
  {
    residual.set_rates(input, solution);
    unknown_pressures.measure(solution);
    if (problem.mesh_moves)
      outlets.measure(solution);
    const ResidualNorms norms = residual.set(input, solution, is_explicit);
    convergence.take(norms, unknown_pressures.residual());
    report.corrections = iteration;
    report.residual = convergence.residual();
    // Where a large pressure is at rest, its round-off moves the body by more than the round-off
    // of the small velocities.
    const bool volume_is_round_off = convergence.volume_stays(correction_is_exact) &&
                                     residual.lost_volume(input.step) < largest_lost_volume;
    // On a mesh that stays the outlets' pressures and flow rates of the step come with its first
    // solve.
    if (convergence.is_solved(volume_is_round_off) &&
        (iteration > 0 || outlets.is_empty() || problem.mesh_moves))
      break;
    if (!convergence.is_finite() || iteration == problem.newton.maximum_iterations)
      convergence.fail(problem, terms, residual.momentum_work, residual.mass_work);
    prepare_correction(solution, convergence.is_slow(), iteration, report);
    correct(input, solution, convergence.scales(), report);
  }
  outlets.finish_step(input.step);
  solution.acceleration.equ(1., residual.acceleration_of_past());
}
} // namespace Continua
