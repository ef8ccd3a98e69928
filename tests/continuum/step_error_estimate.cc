// The estimated local error of a step against the true one, of the oscillator u' = -w^2 d, d' = u,
// whose exact solution starts from the numbers before the step: the ratio tends to 1, also right
// after a change of the step, and the order is that of the scheme and one more. Backward
// differencing finds its older level among three, or on the parabola through them.

#include <continua/continuum/step_error_estimate.h>
#include <continua/time_integration/time_control.h>

#include "../unit_test.h"

#include <limits>
#include <string>

namespace test_of_step_error_estimate
{
using namespace Continua;

namespace
{
constexpr double angular = 2.;

/// u and d at the present time, one step before, and two.
struct Oscillator
{
  double u[3] = {0., 0., 0.};
  double d[3] = {1., 1., 1.};

  void advance(const Step &step, const StepErrorEstimate &estimate)
  {
    double u_older = u[1], d_older = d[1];
    if (estimate.wants_another_level(step))
    {
      const StepErrorEstimate::Weights w = estimate.weights_of_level(step.older_distance);
      u_older = w[0] * u[0] + w[1] * u[1] + w[2] * u[2];
      d_older = w[0] * d[0] + w[1] * d[1] + w[2] * d[2];
    }
    const BranchCoefficients c = step.branch(std::numeric_limits<double>::infinity());
    const double d_plus = c.old * d[0] + c.older * d_older + c.velocity_old * u[0];
    double u_new = (-step.a1 * u[0] - step.a2 * u_older - angular * angular * d_plus) /
                   (step.a0 + angular * angular * c.velocity);
    double d_new = c.velocity * u_new + d_plus;
    if (step.extrapolate)
    {
      u_new = 2. * u_new - u[0];
      d_new = 2. * d_new - d[0];
    }
    for (unsigned int i = 2; i > 0; --i)
    {
      u[i] = u[i - 1];
      d[i] = d[i - 1];
    }
    u[0] = u_new;
    d[0] = d_new;
  }
};

struct Errors
{
  double estimated = 0.;
  double ratio = 0.; ///< to the true one
  bool known = false;
};

/// After n_equal steps of a size and one of `change` times that; of the second step after the
/// change if `after`.
Errors errors(const Scheme scheme,
              const Update update,
              const double size,
              const double change,
              const bool after)
{
  Oscillator numbers;
  StepErrorEstimate estimate;
  double time = 0., size_old = size;
  const unsigned int n_equal = std::lround(0.6 / size);
  const unsigned int n = n_equal + (after ? 2 : 1);
  Errors result;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double h = i < n_equal ? size : change * size;
    Step step;
    if (scheme == Scheme::crank_nicolson)
      step = crank_nicolson_step(time, h);
    else if (scheme == Scheme::backward_differencing && i > 0)
      step = backward_differencing_step(time, h, i > n_equal ? size_old : h, update);
    else
      step = euler_step(time, h, update);
    step.is_start = i == 0;
    const Oscillator before = numbers;
    numbers.advance(step, estimate);
    estimate.advance(step);
    // What the scheme makes of exact past values: of the numbers before the step, by the exact
    // solution through them.
    Oscillator exact = before, local;
    const auto at = [&](const double s)
    { return before.u[0] * std::cos(angular * s) - angular * before.d[0] * std::sin(angular * s); };
    const auto displacement_at = [&](const double s)
    { return before.d[0] * std::cos(angular * s) + before.u[0] / angular * std::sin(angular * s); };
    local = exact;
    local.u[1] = at(-h);
    local.d[1] = displacement_at(-h);
    StepErrorEstimate equal;
    Step level = euler_step(time - h, h, update);
    level.is_start = true;
    equal.advance(level);
    local.advance(step, equal);
    const double true_error = local.u[0] - at(h);
    result.known = estimate.is_known();
    if (result.known)
    {
      const StepErrorEstimate::Weights &w = estimate.prediction();
      result.estimated = estimate.factor() * (numbers.u[0] - w[0] * before.u[0] -
                                              w[1] * before.u[1] - w[2] * before.u[2]);
      result.ratio = result.estimated / true_error;
    }
    time += h;
    size_old = h;
  }
  return result;
}

void scheme_test(const std::string &name, const Scheme scheme, const Update update, const int order)
{
  const auto equal = [&](const double size) { return errors(scheme, update, size, 1., false); };
  const Errors coarse = equal(0.01), fine = equal(0.0025);
  check::is_true(name + ": known", coarse.known && fine.known);
  check::absolute(name + ": tends to the true error", fine.ratio, 1., 0.02);
  check::is_true(name + ": the faster the smaller the step",
                 std::abs(fine.ratio - 1.) < 0.3 * std::abs(coarse.ratio - 1.));
  check::absolute(name + ": order", std::log2(coarse.estimated / fine.estimated) / 2., order, 0.1);
  for (const double change : {0.5, 0.125, 2.})
    for (const bool after : {false, true})
    {
      const Errors changed = errors(scheme, update, 0.0025, change, after);
      check::absolute(name + ": " + (after ? "after" : "in") + " a step " + std::to_string(change) +
                          " times as long",
                      changed.ratio, 1., 0.06);
    }
}
} // namespace

UNIT_TEST(step_error_estimate)
{
  scheme_test("euler, trapezoidal", Scheme::euler_implicit, Update::trapezoidal, 2);
  scheme_test("euler, implicit", Scheme::euler_implicit, Update::implicit, 2);
  scheme_test("backward differencing", Scheme::backward_differencing, Update::implicit, 3);
  scheme_test("crank nicolson", Scheme::crank_nicolson, Update::midpoint, 3);

  // The schemes' constants, after steps of one size: by hand.
  StepErrorEstimate estimate;
  const auto ratio_of = [&](const auto &make)
  {
    estimate = StepErrorEstimate();
    unsigned int n_until_known = 0;
    for (unsigned int i = 0; i < 40; ++i)
    {
      Step step = make(i);
      step.is_start = i == 0;
      estimate.advance(step);
      if (!estimate.is_known())
        ++n_until_known;
    }
    std::cout << "unknown in " << n_until_known << " steps" << std::endl;
    return estimate.factor();
  };
  check::absolute("euler: 1/2", ratio_of([](int) { return euler_step(0., 0.1, Update::implicit); }),
                  0.5, 1e-12);
  check::absolute("backward differencing: 2/9",
                  ratio_of(
                      [](const int i)
                      {
                        return i == 0 ? euler_step(0., 0.1, Update::implicit)
                                      : backward_differencing_step(0., 0.1, 0.1, Update::implicit);
                      }),
                  2. / 9., 1e-12);
  check::absolute("crank nicolson: 1/12",
                  ratio_of([](int) { return crank_nicolson_step(0., 0.1); }), 1. / 12., 1e-12);
}
} // namespace test_of_step_error_estimate
