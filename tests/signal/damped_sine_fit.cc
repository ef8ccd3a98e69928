#include "../unit_test.h"

#include <continua/signal/damped_sine_fit.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace test_of_damped_sine_fit
{
using namespace Continua;

namespace
{
struct Signal
{
  std::vector<double> times, values;
};

Signal sample(const double first,
              const double step,
              const unsigned int n,
              const std::function<double(double)> &function)
{
  Signal signal;
  for (unsigned int i = 0; i < n; ++i)
  {
    signal.times.push_back(first + i * step);
    signal.values.push_back(function(signal.times.back()));
  }
  return signal;
}

double mode(const double time,
            const double frequency,
            const double decay,
            const double amplitude,
            const double phase)
{
  return amplitude * std::exp(-decay * time) * std::sin(2. * M_PI * frequency * time + phase);
}

double noise()
{
  static unsigned int state = 1;
  state = 1664525u * state + 1013904223u;
  return state / 2147483648. - 1.;
}

void test_one_mode()
{
  const Signal signal =
      sample(0.5, 1e-3, 2001, [](const double t) { return 7. + mode(t, 3., 0.4, 2., 1.); });
  const DampedSineFit fit = fit_damped_sines(signal.times, signal.values, {3.3});
  check::is_true("one mode converged", fit.converged);
  check::relative("offset", fit.offset, 7., 1e-9);
  check::relative("frequency", fit.components[0].frequency, 3., 1e-9);
  check::relative("decay rate", fit.components[0].decay_rate, 0.4, 1e-8);
  check::relative("amplitude at time 0", fit.components[0].amplitude, 2., 1e-8);
  check::relative("phase at time 0", fit.components[0].phase, 1., 1e-8);
  check::absolute("residual", fit.residual, 0., 1e-9);
  check::absolute("explained", fit.explained, 1., 1e-9);

  const Signal growing =
      sample(0., 1e-3, 4000, [](const double t) { return mode(t, 5., -0.6, 1e-6, -2.) - 3e-6; });
  const DampedSineFit growth = fit_damped_sines(growing.times, growing.values, {5.});
  check::relative("growing", growth.components[0].decay_rate, -0.6, 1e-7);
  check::relative("phase of the growing", growth.components[0].phase, -2., 1e-7);

  const Signal strong =
      sample(0., 1e-3, 2000, [](const double t) { return mode(t, 4., 8., 1., 0.5); });
  const DampedSineFit strongly = fit_damped_sines(strong.times, strong.values, {4.2});
  check::relative("strongly damped", strongly.components[0].decay_rate, 8., 1e-7);
  check::relative("strongly damped frequency", strongly.components[0].frequency, 4., 1e-7);
}

void test_modes_of_a_beam()
{
  const auto beam = [](const double t)
  {
    return mode(t, 3.3624, 0.2, 1., 0.3) + mode(t, 16.89, 1., 0.05, 1.) +
           mode(t, 21.87, 1.5, 0.02, -0.5) - 0.1;
  };
  const Signal signal = sample(0., 1e-4, 20001, beam);
  const DampedSineFit fit = fit_damped_sines(signal.times, signal.values, {3.5, 16., 23.});
  check::is_true("three modes converged", fit.converged && fit.components.size() == 3);
  check::relative("first frequency", fit.components[0].frequency, 3.3624, 1e-6);
  check::relative("second frequency", fit.components[1].frequency, 16.89, 1e-6);
  check::relative("third frequency", fit.components[2].frequency, 21.87, 1e-6);
  check::relative("first decay rate", fit.components[0].decay_rate, 0.2, 1e-5);
  check::relative("third decay rate", fit.components[2].decay_rate, 1.5, 1e-5);
  check::relative("second amplitude", fit.components[1].amplitude, 0.05, 1e-5);
  check::relative("offset of three modes", fit.offset, -0.1, 1e-6);

  // Fewer samples with noise of 1 % of the amplitude: the frequency averages out all but about
  // 2e-5.
  Signal noisy = sample(0., 1e-3, 2001, beam);
  for (double &value : noisy.values)
    value += 0.01 * noise();
  const DampedSineFit fit_noisy = fit_damped_sines(noisy.times, noisy.values, {3.5, 16., 23.});
  check::relative("first frequency with noise", fit_noisy.components[0].frequency, 3.3624, 1e-4);
  check::relative("second frequency with noise", fit_noisy.components[1].frequency, 16.89, 1e-3);
  check::absolute("decay with noise",
                  std::exp(-fit_noisy.components[0].decay_rate / fit_noisy.components[0].frequency),
                  std::exp(-0.2 / 3.3624), 1e-3);
  check::relative("residual of the noise", fit_noisy.residual, 0.01 / std::sqrt(3.), 0.05);
}

void test_long_record()
{
  const Signal signal =
      sample(0., 1e-4, 300001, [](const double t) { return mode(t, 100. / 30., 0.01, 1., 0.); });
  const DampedSineFit fit = fit_damped_sines(signal.times, signal.values, {3.45});
  check::relative("frequency of a long record", fit.components[0].frequency, 100. / 30., 1e-9);
  check::relative("decay of a long record", fit.components[0].decay_rate, 0.01, 1e-6);

  // Steps that grow from 1 to 3 ms.
  Signal uneven;
  for (double t = 0.; t < 4.; t += 1e-3 * (1. + 0.5 * t))
  {
    uneven.times.push_back(t);
    uneven.values.push_back(mode(t, 2., 0.1, 1., 0.));
  }
  check::relative("uneven steps",
                  fit_damped_sines(uneven.times, uneven.values, {2.1}).components[0].frequency, 2.,
                  1e-8);
}

void test_failures()
{
  const auto undefined = [](const DampedSineFit &fit)
  {
    return !fit.converged && std::isnan(fit.offset) && std::isnan(fit.residual) &&
           fit.components.size() == 1 && std::isnan(fit.components[0].frequency);
  };
  const Signal sine = sample(0., 0.1, 50, [](const double t) { return mode(t, 0.5, 0., 1., 0.); });
  check::is_true("constant",
                 undefined(fit_damped_sines(sine.times, std::vector<double>(50, 3.), {0.5})));
  check::is_true("too short", undefined(fit_damped_sines({0., 1., 2.}, {0., 1., 0.}, {0.5})));
  check::is_true("too few per period", undefined(fit_damped_sines(sine.times, sine.values, {8.})));
  std::vector<double> broken = sine.values;
  broken[7] = std::numeric_limits<double>::quiet_NaN();
  check::is_true("not finite", undefined(fit_damped_sines(sine.times, broken, {0.5})));
  check::throws<std::invalid_argument>(
      "no start", [&]() { fit_damped_sines(sine.times, sine.values, {}); }, "start frequencies");
  check::throws<std::invalid_argument>(
      "negative start", [&]() { fit_damped_sines(sine.times, sine.values, {-1.}); }, "positive");
  check::throws<std::invalid_argument>(
      "lengths", [&]() { fit_damped_sines({0.}, sine.values, {1.}); }, "as many");
}
} // namespace

UNIT_TEST(damped_sine_fit)
{
  test_one_mode();
  test_modes_of_a_beam();
  test_long_record();
  test_failures();
}
} // namespace test_of_damped_sine_fit
