#include <continua/continuum/newton.h>

#include <continua/base/input_error.h>
#include <continua/continuum/step_extremes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
namespace
{
/// Of the terms that cancel, which a solve leaves.
constexpr double round_off = 1e-13;
/// Where a residual of volume counts as round-off of a pressure: the part of the volume that it
/// loses in a step.
constexpr double largest_lost_volume = 1e-12;
/// Share of the state by which differences shift it. They are central: the error of terms of the
/// third degree is its square.
constexpr double difference = 1e-6;

/// While it lives, wall time counts as that of a factor, not as that of the solve around it.
class FactorTime
{
public:
  explicit FactorTime(dealii::TimerOutput &timer) : timer(timer)
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
  dealii::TimerOutput &timer;
};

/// Its largest entry; no number if one of them is none, over which a maximum may pass.
double largest_of(const DistributedVector &residual)
{
  return residual.linfty_norm() + 0. * residual.l1_norm();
}
} // namespace

Newton::Newton(const Problem &problem,
               Operators &operators,
               OutletCoupling &outlets,
               CavityCoupling &cavities,
               Log &log)
    : problem(problem),
      operators(operators),
      outlets(outlets),
      cavities(cavities),
      log(log),
      krylov(BlockKrylov::Method::gmres, 3 * problem.newton.most_krylov_iterations)
{
}

void Newton::reinit()
{
  zero_velocity = operators.velocity_vector();
  for (DistributedVector *vector :
       {&past_acceleration, &momentum, &momentum_work, &velocity_change})
    vector->reinit(zero_velocity);
  mass = operators.pressure_vector();
  for (DistributedVector *vector : {&mass_work, &pressure_change, &volumes})
    vector->reinit(mass);
  DistributedVector one(mass);
  one = 1.;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    operators.multiply_pressure_mass(region, mass_work, one);
    volumes.add(1., mass_work);
  }
  krylov.use(operators.solves_with_kept_derivative() ? BlockKrylov::Method::fgmres
                                                     : BlockKrylov::Method::gmres);
  krylov.reinit(zero_velocity, mass);
  for (DistributedVector *vector : {&shifted.velocity, &shifted.acceleration})
    vector->reinit(zero_velocity);
  for (DistributedVector *vector : {&shifted.pressure, &shifted.pressure_rate})
    vector->reinit(mass);
  if (problem.has_regions_of(RegionModel::finite_solid))
    shifted.displacement.reinit(zero_velocity);
  if (problem.mesh_moves)
    for (DistributedVector *vector :
         {&shifted.mesh_displacement, &shifted.mesh_velocity, &mesh_change})
      vector->reinit(zero_velocity);
  has_factor = false;
}

void Newton::set_rates(const NewtonInput &input, BalancedStep &balanced) const
{
  balanced.acceleration.equ(1., past_acceleration);
  balanced.acceleration.add(input.step.a0, balanced.velocity);
  const double factor = 1. / input.step.pressure_time;
  balanced.pressure_rate.equ(factor, balanced.pressure);
  balanced.pressure_rate.add(-factor, input.predicted_pressure);
  if (problem.has_regions_of(RegionModel::finite_solid))
  {
    balanced.displacement.equ(1., input.predicted_displacement);
    balanced.displacement.add(BranchHistory::step_displacement(input.step), balanced.velocity);
  }
  operators.move_mesh(balanced);
  operators.check_mesh(balanced);
}

void Newton::subtract_linear_terms(const SystemCoefficients &coefficients,
                                   const DistributedVector &velocity,
                                   const DistributedVector &pressure,
                                   DistributedVector &momentum_rows,
                                   DistributedVector &mass_rows,
                                   ResidualScales &scales)
{
  const auto subtract = [](const DistributedVector &term, DistributedVector &rows, double &scale)
  {
    scale = std::max(scale, term.linfty_norm());
    rows.add(-1., term);
  };
  momentum_work = 0.;
  operators.add_velocity_product(velocity, momentum_work);
  subtract(momentum_work, momentum_rows, scales.momentum);
  mass_work = 0.;
  operators.add_divergence(velocity, mass_work);
  subtract(mass_work, mass_rows, scales.mass);
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    if (!coefficients.has(region))
      continue;
    operators.multiply_gradient(region, momentum_work, pressure);
    subtract(momentum_work, momentum_rows, scales.momentum);
    const double compressibility = coefficients.compressibility[region];
    if (compressibility == 0.)
      continue;
    operators.multiply_pressure_mass(region, mass_work, pressure);
    mass_work *= compressibility;
    subtract(mass_work, mass_rows, scales.mass);
  }
}

Newton::Norms Newton::set_residuals(const NewtonInput &input, const BalancedStep &balanced)
{
  ResidualScales largest{input.momentum.linfty_norm(), input.mass.linfty_norm()};
  momentum.equ(1., input.momentum);
  mass.equ(1., input.mass);
  subtract_linear_terms(input.coefficients, balanced.velocity, balanced.pressure, momentum, mass,
                        largest);
  // The inertia of a short step is a small difference of large terms, also within whole terms.
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (!input.coefficients.has(region))
    {
      operators.multiply_mass(region, momentum_work, balanced.velocity);
      largest.momentum =
          std::max(largest.momentum,
                   input.step.a0 * problem.materials[region].density * momentum_work.linfty_norm());
    }
  momentum_work = 0.;
  mass_work = 0.;
  operators.add_flux_correction(balanced.pressure, mass_work);
  operators.add_nonlinear_terms(balanced, momentum_work, mass_work);
  largest.momentum = std::max(largest.momentum, momentum_work.linfty_norm());
  momentum.add(-1., momentum_work);
  largest.mass = std::max(largest.mass, mass_work.linfty_norm());
  mass.add(-1., mass_work);

  Norms norms;
  const ResidualScales scales = operators.residual_scales(balanced.velocity, balanced.pressure);
  norms.momentum_round_off = round_off * std::max(largest.momentum, scales.momentum);
  norms.mass_round_off = round_off * std::max(largest.mass, scales.mass);
  // On a mesh that stays each solve has the ports' forces anew.
  if (problem.mesh_moves)
    outlets.add_to_residual(1., momentum);
  momentum_work.equ(1., momentum);
  if (!problem.mesh_moves)
    outlets.add_forces(1., momentum_work);
  mass_work.equ(1., mass);
  restrict_rows(momentum_work, mass_work);
  norms.momentum = largest_of(momentum_work);
  norms.mass = largest_of(mass_work);
  return norms;
}

void Newton::add_differences(const BalancedStep &balanced,
                             const DistributedVector &of_velocity,
                             const DistributedVector &of_pressure,
                             DistributedVector &momentum_rows,
                             DistributedVector &mass_rows)
{
  // Velocity and pressure each change by no more than a small part of what they are. Of a body in
  // finite deformation the velocity stands for the displacement, too, beside which it may be
  // nothing.
  const auto share = [](const double change, const double value) {
    return value > 0. ? change / value : change > 0. ? 1. : 0.;
  };
  double velocity = balanced.velocity.linfty_norm();
  if (problem.has_regions_of(RegionModel::finite_solid))
  {
    const DistributedVector &of_body = problem.mesh_moves && !balanced.step.finds_unloaded_shape
                                           ? balanced.mesh_displacement
                                           : balanced.displacement;
    velocity =
        std::max(velocity, of_body.linfty_norm() / BranchHistory::step_displacement(balanced.step));
  }
  const double largest =
      std::max(share(of_velocity.linfty_norm(), velocity),
               share(of_pressure.linfty_norm(), balanced.pressure.linfty_norm()));
  if (largest == 0.)
    return;
  const double distance = difference / largest;
  shifted.step = balanced.step;
  shifted.cavity_pressures = balanced.cavity_pressures;
  if (problem.mesh_moves)
    operators.set_mesh_change(balanced.step, of_velocity, mesh_change);
  for (const double sign : {1., -1.})
  {
    const auto shift = [&](DistributedVector &target, const DistributedVector &value,
                           const double factor, const DistributedVector &change)
    {
      target.equ(1., value);
      target.add(sign * distance * factor, change);
    };
    shift(shifted.velocity, balanced.velocity, 1., of_velocity);
    shift(shifted.acceleration, balanced.acceleration, balanced.step.a0, of_velocity);
    shift(shifted.pressure, balanced.pressure, 1., of_pressure);
    shift(shifted.pressure_rate, balanced.pressure_rate, 1. / balanced.step.pressure_time,
          of_pressure);
    if (problem.has_regions_of(RegionModel::finite_solid))
      shift(shifted.displacement, balanced.displacement,
            BranchHistory::step_displacement(balanced.step), of_velocity);
    if (problem.mesh_moves)
    {
      // The motion of the mesh is linear within a step.
      shift(shifted.mesh_displacement, balanced.mesh_displacement, 1., mesh_change);
      shift(shifted.mesh_velocity, balanced.mesh_velocity,
            1. / BranchHistory::step_displacement(balanced.step), mesh_change);
    }
    momentum_work = 0.;
    mass_work = 0.;
    operators.add_nonlinear_terms(shifted, momentum_work, mass_work);
    if (problem.mesh_moves)
    {
      outlets.measure(shifted);
      outlets.add_to_residual(-1., momentum_work);
    }
    momentum_rows.add(0.5 * sign / distance, momentum_work);
    mass_rows.add(0.5 * sign / distance, mass_work);
  }
  if (problem.mesh_moves)
    outlets.measure(balanced);
}

void Newton::set_derivative_product(const NewtonInput &input,
                                    const BalancedStep &balanced,
                                    const DistributedVector &of_velocity,
                                    const DistributedVector &of_pressure,
                                    DistributedVector &momentum_rows,
                                    DistributedVector &mass_rows)
{
  momentum_rows = 0.;
  mass_rows = 0.;
  ResidualScales unused;
  subtract_linear_terms(input.coefficients, of_velocity, of_pressure, momentum_rows, mass_rows,
                        unused);
  momentum_rows *= -1.;
  mass_rows *= -1.;
  if (takes_differences())
    add_differences(balanced, of_velocity, of_pressure, momentum_rows, mass_rows);
  else
  {
    momentum_work = 0.;
    mass_work = 0.;
    operators.add_derivative_product(of_velocity, of_pressure, momentum_work, mass_work);
    momentum_rows.add(1., momentum_work);
    mass_rows.add(1., mass_work);
  }
  restrict_rows(momentum_rows, mass_rows);
}

void Newton::restrict_rows(DistributedVector &momentum_rows, DistributedVector &mass_rows) const
{
  if (!problem.mesh_moves || outlets.is_empty())
  {
    operators.restrict_residuals(momentum_rows, mass_rows);
    return;
  }
  const std::vector<double> of_ports = outlets.port_rows(momentum_rows);
  operators.restrict_residuals(momentum_rows, mass_rows);
  outlets.set_port_rows(of_ports, momentum_rows);
}

bool Newton::takes_differences() const
{
  return problem.mesh_moves || problem.newton.tangent_products == TangentProducts::differences;
}

double Newton::lost_volume(const Step &step) const
{
  double largest = 0.;
  for (unsigned int i = 0; i < volumes.locally_owned_size(); ++i)
    if (volumes.begin()[i] > 0.) // a hanging node has none
      largest = std::max(largest, std::abs(mass_work.begin()[i]) / volumes.begin()[i]);
  return step.size() * dealii::Utilities::MPI::max(largest, problem.communicator);
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
  operators.solve(zero_velocity, momentum_rows, mass_rows, of_velocity, of_pressure, report);
  if (has_outlets)
    outlets.complete_change(of_ports, of_velocity, of_pressure);
}

bool Newton::solve_by_krylov(const NewtonInput &input,
                             const BalancedStep &balanced,
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
  restrict_rows(momentum_rows, mass_rows);
  krylov.scale.block(0) = 1. / momentum_size;
  krylov.scale.block(1) = 1. / mass_size;
  krylov.set_right_hand_side(momentum_rows, mass_rows);
  const auto product = [&](const DistributedVector &velocity, const DistributedVector &pressure,
                           DistributedVector &of_momentum, DistributedVector &of_mass)
  { set_derivative_product(input, balanced, velocity, pressure, of_momentum, of_mass); };
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
  if (!operators.solves_with_kept_derivative())
    report.linear_iterations += n_iterations;
  krylov_iterations += n_iterations;
  return n_iterations < 3 * most;
}

bool Newton::correct_by_krylov(const NewtonInput &input,
                               const BalancedStep &balanced,
                               const ResidualScales &scales,
                               StepReport &report)
{
  const bool has_converged = solve_by_krylov(input, balanced, scales, momentum, mass,
                                             velocity_change, pressure_change, report);
  // All solves of the step together: a new factor serves many steps.
  if (krylov_iterations > problem.newton.most_krylov_iterations)
    factor_is_poor = true;
  // What the pressures of cavities do is wanted to the same tolerance.
  const double flow = cavities.largest_flow();
  cavities.respond(
      [&](DistributedVector &of_momentum, DistributedVector &of_mass, DistributedVector &velocity,
          DistributedVector &pressure)
      {
        solve_by_krylov(input, balanced, {of_momentum.linfty_norm(), flow}, of_momentum, of_mass,
                        velocity, pressure, report);
      });
  return has_converged;
}

void Newton::solve(const NewtonInput &input, BalancedStep &balanced, StepReport &report)
{
  if (input.system_is_new)
    has_factor = false;
  outlets.predict(input.step, input.velocity_old);
  if (problem.mesh_moves)
    outlets.set_port_velocities(balanced.velocity);
  cavities.begin_step(input.step);
  past_acceleration.equ(1., balanced.acceleration);
  krylov_iterations = 0;
  double largest_momentum = 0., largest_mass = 0., previous = 0.;
  double previous_mass = 0.;
  bool takes_krylov = false, momentum_was_round_off = false, correction_is_exact = false;
  const bool may_take_krylov = (problem.mesh_moves || (outlets.is_empty() && cavities.is_empty() &&
                                                       operators.has_derivative_products())) &&
                               problem.newton.slow_iteration == SlowIteration::krylov;
  // The factor leaves out what the mesh's motion does to the liquid, which is much in a long step.
  const bool is_exact_at_once =
      problem.mesh_moves && input.step.is_towards_rest && !input.step.finds_unloaded_shape;
  for (unsigned int iteration = 0;; ++iteration)
  {
    set_rates(input, balanced);
    cavities.measure(balanced);
    if (problem.mesh_moves)
      outlets.measure(balanced);
    const Norms norms = set_residuals(input, balanced);
    largest_momentum = std::max(largest_momentum, norms.momentum);
    largest_mass = std::max(largest_mass, norms.mass);
    const double tolerance = problem.newton.tolerance;
    const double accepted_momentum =
        std::max(tolerance * largest_momentum, norms.momentum_round_off);
    const double accepted_mass = std::max(tolerance * largest_mass, norms.mass_round_off);
    const double of_cavities = cavities.residual();
    const bool momentum_is_round_off = norms.momentum <= norms.momentum_round_off;
    // What is round-off says nothing of the iteration.
    const double of_momentum = momentum_is_round_off ? 0. : norms.momentum / largest_momentum;
    const double of_mass = norms.mass <= norms.mass_round_off ? 0. : norms.mass / largest_mass;
    report.corrections = iteration;
    report.residual = std::max({of_momentum, of_mass, of_cavities});
    const bool is_slow = iteration > 0 && report.residual > problem.newton.slowest_rate * previous;
    // Where a large pressure is at rest, its round-off moves the body by more than the round-off
    // of the small velocities.
    const bool volume_is_round_off = momentum_is_round_off && momentum_was_round_off &&
                                     correction_is_exact && norms.mass > 0.5 * previous_mass &&
                                     lost_volume(input.step) < largest_lost_volume;
    const bool is_solved = norms.momentum <= accepted_momentum &&
                           (norms.mass <= accepted_mass || volume_is_round_off) &&
                           of_cavities <= std::max(tolerance, round_off);
    // On a mesh that stays the outlets' pressures and flow rates of the step come with its first
    // solve.
    if (is_solved && (iteration > 0 || outlets.is_empty() || problem.mesh_moves))
      break;
    // NaN fails the comparison.
    const bool is_finite =
        norms.momentum < HUGE_VAL && norms.mass < HUGE_VAL && of_cavities < HUGE_VAL;
    if (!is_finite || iteration == problem.newton.maximum_iterations)
    {
      // What the input cannot say at a time no shorter step can either.
      if (const std::string reason = reason_not_finite(problem.communicator);
          !is_finite && !reason.empty())
        throw RunError("Newton's iteration met a residual that is no number" + reason);
      if (is_finite && of_cavities > std::max(of_momentum, of_mass))
      {
        std::ostringstream text;
        text << "Newton's iteration left the volume of a cavity " << of_cavities
             << " of it away from the one given after " << iteration
             << " iterations (Newton/Maximum iterations); a smaller time step or a volume that "
                "changes more slowly helps";
        throw StepFailure(text.str());
      }
      const bool is_of_momentum = is_finite ? of_momentum >= of_mass : !(norms.momentum < HUGE_VAL);
      std::ostringstream text;
      text << "Newton's iteration ";
      if (is_finite)
        text << "left " << report.residual << " of the largest residual";
      else
        text << "met a residual that is no number";
      text << " of " << (is_of_momentum ? "momentum" : "volume") << ' '
           << operators.place_of_largest(momentum_work, mass_work, is_of_momentum) << ' ';
      if (is_finite)
        text << "after " << iteration << " iterations (Newton/Maximum iterations)";
      else
        text << "in iteration " << iteration;
      text << "; a smaller time step, loads that begin smoothly or a finer mesh help";
      throw StepFailure(text.str());
    }
    previous = report.residual;
    previous_mass = norms.mass;
    momentum_was_round_off = momentum_is_round_off;
    correction_is_exact = operators.solves_with_kept_derivative() && !problem.mesh_moves;
    const bool can_take_krylov = has_factor && !factor_is_poor && may_take_krylov;
    if ((is_slow || is_exact_at_once) && can_take_krylov)
    {
      takes_krylov = true;
      if (!takes_differences())
        operators.keep_derivative(balanced);
    }
    else if (is_slow || !has_factor)
    {
      has_factor = false; // if this fails
      try
      {
        const FactorTime time(log.timer());
        if (operators.linearise(balanced))
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
      cavities.respond(
          [&](DistributedVector &of_momentum, DistributedVector &of_mass,
              DistributedVector &of_velocity, DistributedVector &of_pressure)
          { solve_by_factor(of_momentum, of_mass, of_velocity, of_pressure, report); });
    }
    // On a mesh that moves the derivative that is kept takes the place of a factor.
    else if (operators.solves_with_kept_derivative() && !problem.mesh_moves)
      operators.keep_derivative(balanced);
    if (takes_krylov)
      correction_is_exact = correct_by_krylov(
          input, balanced,
          {std::max(norms.momentum, accepted_momentum), std::max(norms.mass, accepted_mass)},
          report);
    else if (operators.solves_with_kept_derivative() && !problem.mesh_moves)
    {
      // An inexact solve leaves a part of its right-hand side. That is the residual, without the
      // ports' forces it would be much more: their part of the correction is taken out again.
      operators.solve(zero_velocity, momentum_work, mass_work, velocity_change, pressure_change,
                      report);
      outlets.add_pressure_responses(-1., velocity_change, pressure_change);
    }
    else
      solve_by_factor(momentum, mass, velocity_change, pressure_change, report);
    cavities.couple(input.step, velocity_change, pressure_change, balanced.cavity_pressures);
    balanced.velocity.add(1., velocity_change);
    balanced.pressure.add(1., pressure_change);
    if (!problem.mesh_moves)
      outlets.couple(input.step, input.velocity_old, balanced.velocity, balanced.pressure);
  }
  outlets.finish_step(input.step);
  balanced.acceleration.equ(1., past_acceleration);
}
} // namespace Continua
