#include <continua/continuum/newton.h>

#include <continua/base/input_error.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
namespace
{
/// Of the terms that cancel, which a solve leaves.
constexpr double round_off = 1e-13;
} // namespace

Newton::Newton(const Problem &problem, Operators &operators, OutletCoupling &outlets)
    : problem(problem), operators(operators), outlets(outlets)
{
}

void Newton::reinit()
{
  zero_velocity = operators.velocity_vector();
  for (DistributedVector *vector :
       {&past_acceleration, &momentum, &momentum_work, &velocity_change})
    vector->reinit(zero_velocity);
  mass = operators.pressure_vector();
  for (DistributedVector *vector : {&mass_work, &pressure_change})
    vector->reinit(mass);
  has_factor = false;
}

void Newton::set_rates(const NewtonInput &input, BalancedStep &balanced) const
{
  balanced.acceleration.equ(1., past_acceleration);
  balanced.acceleration.add(input.step.a0, balanced.velocity);
  const double factor = 1. / input.step.pressure_time;
  balanced.pressure_rate.equ(factor, balanced.pressure);
  balanced.pressure_rate.add(-factor, input.predicted_pressure);
}

Newton::Norms Newton::set_residuals(const NewtonInput &input, const BalancedStep &balanced)
{
  double momentum_scale = input.momentum.linfty_norm(), mass_scale = input.mass.linfty_norm();
  const auto add = [](const DistributedVector &term, DistributedVector &residual, double &scale)
  {
    scale = std::max(scale, term.linfty_norm());
    residual.add(-1., term);
  };
  momentum.equ(1., input.momentum);
  mass.equ(1., input.mass);
  momentum_work = 0.;
  operators.add_velocity_product(balanced.velocity, momentum_work);
  add(momentum_work, momentum, momentum_scale);
  mass_work = 0.;
  operators.add_divergence(balanced.velocity, mass_work);
  add(mass_work, mass, mass_scale);
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    operators.multiply_gradient(region, momentum_work, balanced.pressure);
    add(momentum_work, momentum, momentum_scale);
    const double compressibility = input.coefficients.compressibility[region];
    if (compressibility == 0.)
      continue;
    operators.multiply_pressure_mass(region, mass_work, balanced.pressure);
    mass_work *= compressibility;
    add(mass_work, mass, mass_scale);
  }
  momentum_work = 0.;
  mass_work = 0.;
  operators.add_flux_correction(balanced.pressure, mass_work);
  operators.add_nonlinear_terms(balanced, momentum_work, mass_work);
  add(momentum_work, momentum, momentum_scale);
  add(mass_work, mass, mass_scale);

  Norms norms;
  const ResidualScales scales = operators.residual_scales(balanced.velocity, balanced.pressure);
  norms.momentum_round_off = round_off * std::max(momentum_scale, scales.momentum);
  norms.mass_round_off = round_off * std::max(mass_scale, scales.mass);
  momentum_work.equ(1., momentum);
  outlets.add_forces(1., momentum_work);
  mass_work.equ(1., mass);
  operators.restrict_residuals(momentum_work, mass_work);
  norms.momentum = momentum_work.linfty_norm();
  norms.mass = mass_work.linfty_norm();
  return norms;
}

void Newton::solve(const NewtonInput &input, BalancedStep &balanced, StepReport &report)
{
  if (input.system_is_new)
    has_factor = false;
  outlets.predict(input.step, input.velocity_old);
  past_acceleration.equ(1., balanced.acceleration);
  double largest_momentum = 0., largest_mass = 0., previous = 0.;
  for (unsigned int iteration = 0;; ++iteration)
  {
    set_rates(input, balanced);
    const Norms norms = set_residuals(input, balanced);
    largest_momentum = std::max(largest_momentum, norms.momentum);
    largest_mass = std::max(largest_mass, norms.mass);
    const double tolerance = problem.newton.tolerance;
    const bool is_solved =
        norms.momentum <= std::max(tolerance * largest_momentum, norms.momentum_round_off) &&
        norms.mass <= std::max(tolerance * largest_mass, norms.mass_round_off);
    // What is round-off says nothing of the iteration.
    const double of_momentum =
        norms.momentum <= norms.momentum_round_off ? 0. : norms.momentum / largest_momentum;
    const double of_mass = norms.mass <= norms.mass_round_off ? 0. : norms.mass / largest_mass;
    report.corrections = iteration;
    report.residual = std::max(of_momentum, of_mass);
    // The outlets' pressures and flow rates of the step come with its first solve.
    if (is_solved && (iteration > 0 || outlets.is_empty()))
      break;
    // NaN fails the comparison.
    const bool is_finite = norms.momentum < HUGE_VAL && norms.mass < HUGE_VAL;
    if (!is_finite || iteration == problem.newton.maximum_iterations)
    {
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
    const bool is_slow = iteration > 0 && report.residual > problem.newton.slowest_rate * previous;
    previous = report.residual;
    if (!has_factor || is_slow)
    {
      operators.linearise(balanced);
      has_factor = true;
      report.factored = true;
      outlets.respond(report);
    }
    operators.solve(zero_velocity, momentum, mass, velocity_change, pressure_change, report);
    balanced.velocity.add(1., velocity_change);
    balanced.pressure.add(1., pressure_change);
    outlets.couple(input.step, input.velocity_old, balanced.velocity, balanced.pressure);
  }
  outlets.finish_step(input.step);
  balanced.acceleration.equ(1., past_acceleration);
}
} // namespace Continua
