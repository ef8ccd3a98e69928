// Coefficients of one step against values derived by hand; what each formula is exact for; and the
// amplification of one mode u' = - omega^2 d, d' = u against closed formulas, theta = omega dt.

#include <continua/time_integration/step.h>

#include "../unit_test.h"

#include <array>
#include <complex>
#include <limits>

namespace test_of_step
{
using namespace Continua;

namespace
{
const double never = std::numeric_limits<double>::infinity();

/// A mode of unit step and frequency theta.
struct Mode
{
  double theta;
  double u = 1., u_older = 1., d = 0.3, d_older = 0.3;

  void advance(const Step &step)
  {
    const BranchCoefficients c = step.branch(never);
    const double past = c.old * d + c.older * d_older + c.velocity_old * u;
    const double square = theta * theta;
    // a0 U + a1 U_old + a2 U_older + theta^2 D = 0
    const double at_level =
        -(step.a1 * u + step.a2 * u_older + square * past) / (step.a0 + square * c.velocity);
    const double d_balanced = past + c.velocity * at_level;
    u_older = u;
    d_older = d;
    u = step.extrapolate ? 2. * at_level - u : at_level;
    d = step.extrapolate ? 2. * d_balanced - d : d_balanced;
  }
  double amplitude() const { return std::hypot(u, theta * d); }
};

/// Spectral radius of a one-step method, from the trace and determinant of its matrix.
double radius(const Step &step, const double theta)
{
  Mode one{theta, 1., 0., 0., 0.}, two{theta, 0., 0., 1., 0.};
  one.advance(step);
  two.advance(step);
  const double half_trace = 0.5 * (one.u + two.d);
  const double determinant = one.u * two.d - two.u * one.d;
  const std::complex<double> root =
      std::sqrt(std::complex<double>(half_trace * half_trace - determinant));
  return std::max(std::abs(half_trace + root), std::abs(half_trace - root));
}

/// Decay a step of backward differencing with the implicit update, measured over many.
double decay_of_backward_differencing(const double theta, const unsigned int n_steps)
{
  Mode mode{theta};
  const Step step = backward_differencing_step(0., 1., 1., Update::implicit);
  for (unsigned int i = 0; i < n_steps; ++i)
    mode.advance(step);
  const double before = mode.amplitude();
  for (unsigned int i = 0; i < n_steps; ++i)
    mode.advance(step);
  return std::pow(mode.amplitude() / before, 1. / n_steps);
}
} // namespace

UNIT_TEST(step)
{
  {
    const Step step = euler_step(0.3, 0.1, Update::trapezoidal);
    check::absolute("euler: times", step.time + step.balance_time, 0.8, 1e-14);
    check::absolute("euler: a0", step.a0, 10., 1e-12);
    check::absolute("euler: a1", step.a1, -10., 1e-12);
    check::absolute("euler: a2", step.a2, 0., 0.);
    check::absolute("euler, trapezoidal: pressure", step.pressure_time, 0.05, 1e-15);
    check::is_true("euler, trapezoidal: old divergence", step.divergence_old && !step.extrapolate);
    const BranchCoefficients spring = step.branch(never);
    check::absolute("trapezoidal spring: of U", spring.velocity, 0.05, 1e-15);
    check::absolute("trapezoidal spring: of U_old", spring.velocity_old, 0.05, 1e-15);
    check::absolute("trapezoidal spring: of D", spring.old, 1., 1e-15);
    const BranchCoefficients slow = step.branch(0.2);
    check::absolute("trapezoidal branch: of U", slow.velocity, 0.04, 1e-15);
    check::absolute("trapezoidal branch: of U_old", slow.velocity_old, 0.04, 1e-15);
    check::absolute("trapezoidal branch: of D", slow.old, 0.6, 1e-15);
    // tau = 0.05: x = 2, e = exp(-2), g = (1 - e) / 2.
    check::is_true("fast branch: exponential", step.branch_is_exponential(0.05) &&
                                                   !step.branch_is_exponential(0.2) &&
                                                   !step.branch_is_exponential(never));
    const BranchCoefficients fast = step.branch(0.05);
    check::absolute("exponential branch: of D", fast.old, 0.1353352832366127, 1e-15);
    check::absolute("exponential branch: of U", fast.velocity, 0.028383382080915318, 1e-15);
    check::absolute("exponential branch: of U_old", fast.velocity_old, 0.014849853757254048, 1e-15);

    const Step implicit = euler_step(0., 0.1, Update::implicit);
    check::absolute("euler, implicit: pressure", implicit.pressure_time, 0.1, 1e-15);
    check::is_true("euler, implicit: never exponential", !implicit.branch_is_exponential(1e-9));
    check::absolute("implicit branch: of U", implicit.branch(0.2).velocity, 1. / 15., 1e-15);
    check::absolute("implicit branch: of D", implicit.branch(0.2).old, 2. / 3., 1e-15);
  }
  {
    const Step step = backward_differencing_step(0., 0.1, 0.1, Update::implicit);
    check::absolute("backward differencing: a0", step.a0, 15., 1e-12);
    check::absolute("backward differencing: a1", step.a1, -20., 1e-12);
    check::absolute("backward differencing: a2", step.a2, 5., 1e-12);
    check::absolute("backward differencing: pressure", step.pressure_time, 1. / 15., 1e-15);
    check::absolute("backward differencing: of p_old", step.pressure_old, 4. / 3., 1e-14);
    check::absolute("backward differencing: of p_older", step.pressure_older, -1. / 3., 1e-14);
    const Step thesis = backward_differencing_step(0., 0.1, 0.1, Update::trapezoidal);
    check::is_true("backward differencing, trapezoidal",
                   thesis.pressure_time == 0.05 && thesis.pressure_old == 1. &&
                       thesis.pressure_older == 0. && thesis.divergence_old);
  }
  {
    const Step step = crank_nicolson_step(1., 0.1);
    check::absolute("crank nicolson: balanced in the middle", step.balance_time, 1.05, 1e-15);
    check::absolute("crank nicolson: end", step.time, 1.1, 1e-15);
    check::absolute("crank nicolson: a0 of half a step", step.a0, 20., 1e-12);
    check::absolute("crank nicolson: a1 of half a step", step.a1, -20., 1e-12);
    check::absolute("crank nicolson: pressure", step.pressure_time, 0.05, 1e-15);
    check::is_true("crank nicolson: extrapolated", step.extrapolate && !step.divergence_old);
  }

  // Backward differencing is exact for quadratics, for changed steps too: times 0, 0.1, 0.3.
  const double times[3] = {0., 0.1, 0.3};
  const Step changed = backward_differencing_step(0.1, 0.2, 0.1, Update::implicit);
  check::absolute("changed step: constants", changed.a0 + changed.a1 + changed.a2, 0., 1e-13);
  check::absolute("changed step: t", changed.a0 * 0.3 + changed.a1 * 0.1, 1., 1e-13);
  check::absolute("changed step: t^2", changed.a0 * 0.09 + changed.a1 * 0.01, 0.6, 1e-13);
  for (const double tau : {0.02, 0.4, never})
  {
    // D = 1 + t^2 solves dD/dt = U - D / tau with U = 2 t + (1 + t^2) / tau.
    const auto d = [](const double t) { return 1. + t * t; };
    const auto u = [&](const double t) { return 2. * t + d(t) / tau; };
    const std::string name = tau > 1. ? "spring" : tau > 0.1 ? "slow branch" : "fast branch";
    const BranchCoefficients c = changed.branch(tau);
    check::absolute("changed step, quadratic: " + name,
                    c.velocity * u(times[2]) + c.old * d(times[1]) + c.older * d(times[0]),
                    d(times[2]), 1e-13);
    if (tau < 0.1)
      continue;
    const BranchCoefficients t = euler_step(0.1, 0.2, Update::trapezoidal).branch(tau);
    check::absolute("trapezoidal, quadratic: " + name,
                    t.velocity * u(0.3) + t.velocity_old * u(0.1) + t.old * d(0.1), d(0.3), 1e-13);
  }
  {
    // Crank-Nicolson's spring with a velocity linear in time: D = t^2.
    const BranchCoefficients c = crank_nicolson_step(0.1, 0.2).branch(never);
    check::absolute("crank nicolson, quadratic", 2. * (c.old * 0.01 + c.velocity * 0.4) - 0.01,
                    0.09, 1e-14);
    // The exponential update is exact for a velocity linear in time, U = t from D = 0:
    // D = tau t - tau^2 (1 - exp(-t / tau)).
    const double tau = 0.05, exact = tau * 0.2 - tau * tau * (1. - std::exp(-4.));
    const BranchCoefficients t = euler_step(0., 0.2, Update::trapezoidal).branch(tau);
    check::absolute("trapezoidal, exponential: linear velocity", t.velocity * 0.2, exact, 1e-15);
    const BranchCoefficients m = crank_nicolson_step(0., 0.2).branch(tau);
    check::absolute("crank nicolson, exponential: linear velocity", 2. * m.velocity * 0.1, exact,
                    1e-15);
    // Rannacher's half steps are backward Euler for every branch, so that a Maxwell body under a
    // step load, whose D jumps to 1 and stays while the body flows, has the strain 1 + t / tau from
    // its first half step on.
    const Step half = euler_step(0., 0.1, Update::midpoint);
    check::is_true("half step: never exponential", !half.branch_is_exponential(1e-9));
    const double u = 1. / half.branch(tau).velocity;
    check::absolute("half step: elastic jump and flow", half.branch(never).velocity * u,
                    1. + 0.1 / tau, 1e-14);
  }

  const Step thesis = euler_step(0., 1., Update::trapezoidal);
  for (const double theta : {0.1, 1., 2., 3.9})
    check::relative("velocity form, euler: |G| = (1 + theta^2/2)^(-1/2)", radius(thesis, theta),
                    1. / std::sqrt(1. + 0.5 * theta * theta), 1e-12);
  check::absolute("velocity form, euler, theta = 10: real", radius(thesis, 10.), 0.9199, 1e-4);
  check::absolute("velocity form, euler, theta = 100: rings", radius(thesis, 100.), 0.9992, 1e-4);
  for (const double theta : {0.1, 1., 10., 100.})
  {
    check::relative("displacement form, euler: |G| = (1 + theta^2)^(-1/2)",
                    radius(euler_step(0., 1., Update::implicit), theta),
                    1. / std::sqrt(1. + theta * theta), 1e-12);
    check::absolute("crank nicolson: |G| = 1", radius(crank_nicolson_step(0., 1.), theta), 1.,
                    1e-12);
  }
  {
    // Halves of a step obey the formulas of the whole, from the size of the step before it on.
    const std::array<Step, 2> halves =
        halves_of(backward_differencing_step(1., 0.2, 0.3, Update::implicit));
    const Step first = backward_differencing_step(1., 0.1, 0.3, Update::implicit),
               second = backward_differencing_step(1.1, 0.1, 0.1, Update::implicit);
    check::absolute("halves, backward differencing: first", halves[0].a2, first.a2, 1e-13);
    check::absolute("halves, backward differencing: second", halves[1].a2, second.a2, 1e-13);
    check::absolute("halves, backward differencing: middle", halves[0].time, 1.1, 1e-15);
    check::absolute("halves, backward differencing: end", halves[1].time, 1.2, 0.);
    check::absolute("halves, backward differencing: pressure", halves[1].pressure_older,
                    second.pressure_older, 1e-13);
    const std::array<Step, 2> middles = halves_of(crank_nicolson_step(1., 0.2));
    check::absolute("halves, crank nicolson: middle of the second", middles[1].balance_time, 1.15,
                    1e-15);
    check::is_true("halves, crank nicolson: extrapolated", middles[0].extrapolate);
    const std::array<Step, 2> after = halves_of(crank_nicolson_step(1., 0.2, 0.3));
    check::absolute("halves, crank nicolson: before the first", after[0].older_distance, 0.3, 0.);
    check::absolute("halves, crank nicolson: before the second", after[1].older_distance, 0.1, 0.);
    Step start = euler_step(1., 0.2, Update::trapezoidal);
    start.is_start = true;
    check::is_true("halves of a start", halves_of(start)[1].is_start);
    check::is_true("halves of a start: update", halves_of(start)[1].divergence_old);
    check::absolute("halves of a start: a0", halves_of(start)[0].a0, 10., 1e-12);
  }
  // The larger root of (3/2 - i theta) z^2 - 2 z + 1/2 = 0.
  check::relative("backward differencing, theta = 1", decay_of_backward_differencing(1., 40),
                  0.933323, 1e-5);
  check::is_true("backward differencing, theta = 100: damped",
                 decay_of_backward_differencing(100., 10) < 0.1);
}
} // namespace test_of_step
