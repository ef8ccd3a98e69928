#include "../unit_test.h"

#include <continua/signal/signal_analysis.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace test_of_signal_analysis
{
using namespace Continua;

namespace
{
SignalAnalysis analyse(const double first,
                       const double step,
                       const unsigned int n,
                       const std::function<double(double)> &function)
{
  std::vector<double> times, values;
  for (unsigned int i = 0; i < n; ++i)
  {
    times.push_back(first + i * step);
    values.push_back(function(times.back()));
  }
  return analyse_signal(times, values);
}

bool no_oscillation(const SignalAnalysis &result)
{
  return std::isnan(result.frequency_zero_crossings) && std::isnan(result.frequency_fit) &&
         std::isnan(result.decay_per_oscillation_fit) && std::isnan(result.amplitude_fit) &&
         std::isnan(result.offset_fit) && std::isnan(result.phase_fit) &&
         std::isnan(result.fit_residual);
}

void test_sine()
{
  const SignalAnalysis result = analyse(
      0., 1e-3, 3301, [](const double t) { return 2. + 3. * std::sin(2. * M_PI * 2. * t - 0.4); });
  check::relative("maximum", result.maximum, 5., 1e-8);
  check::relative("minimum", result.minimum, -1., 1e-8);
  check::absolute("mean", result.mean, 2., 1e-5);
  check::relative("root mean square", result.root_mean_square, std::sqrt(8.5), 1e-5);
  check::relative("frequency by crossings", result.frequency_zero_crossings, 2., 1e-6);
  check::relative("frequency by fit", result.frequency_fit, 2., 1e-9);
  check::relative("decay by fit", result.decay_per_oscillation_fit, 1., 1e-9);
  check::relative("amplitude by fit", result.amplitude_fit, 3., 1e-9);
  check::relative("offset by fit", result.offset_fit, 2., 1e-9);
  check::relative("phase by fit", result.phase_fit, -0.4, 1e-8);
  check::absolute("residual of the fit", result.fit_residual, 0., 1e-9);
  check::relative("first maximum", result.first_maximum, 5., 1e-8);
  check::relative("its time", result.time_of_first_maximum, (M_PI / 2. + 0.4) / (4. * M_PI), 1e-5);
}

void test_step_load()
{
  // Period 0.25 s.
  const SignalAnalysis result = analyse(
      0., 1e-3, 1101, [](const double t) { return 0.304 * (1. - std::cos(8. * M_PI * t)); });
  check::relative("step load, first maximum", result.first_maximum, 0.608, 1e-6);
  check::relative("step load, its time", result.time_of_first_maximum, 0.125, 1e-5);
  check::relative("step load, mean", result.mean, 0.304, 1e-5);
  check::relative("step load, frequency", result.frequency_fit, 4., 1e-8);
  const SignalAnalysis brief =
      analyse(0., 1e-3, 276, [](const double t) { return 0.304 * (1. - std::cos(8. * M_PI * t)); });
  check::relative("a period and a tenth, first maximum", brief.first_maximum, 0.608, 1e-6);
  check::relative("a period and a tenth, frequency", brief.frequency_fit, 4., 1e-7);
  check::is_true("no two crossings", std::isnan(brief.frequency_zero_crossings));
}

void test_modes()
{
  const SignalAnalysis result = analyse(0., 1e-4, 20001,
                                        [](const double t)
                                        {
                                          const double w = 2. * M_PI * t;
                                          return std::exp(-0.2 * t) * std::sin(3.3624 * w) +
                                                 0.05 * std::exp(-t) * std::sin(16.89 * w + 1.) +
                                                 0.02 * std::sin(21.87 * w);
                                        });
  // Higher modes shift the crossings and the fit of a single sine a little.
  check::relative("crossings with higher modes", result.frequency_zero_crossings, 3.3624, 5e-3);
  check::relative("fit with higher modes", result.frequency_fit, 3.3624, 1e-3);
  check::absolute("decay with higher modes", result.decay_per_oscillation_fit,
                  std::exp(-0.2 / 3.3624), 2e-3);
}

void test_long_record()
{
  const SignalAnalysis result =
      analyse(10., 1e-4, 300001,
              [](const double t)
              { return -1. + std::exp(-0.01 * t) * std::cos(2. * M_PI * 10. / 3. * t); });
  check::relative("long record, crossings", result.frequency_zero_crossings, 10. / 3., 1e-5);
  check::relative("long record, fit", result.frequency_fit, 10. / 3., 1e-9);
  check::relative("long record, decay", result.decay_per_oscillation_fit, std::exp(-0.003), 1e-8);
  check::relative("long record, amplitude", result.amplitude_fit, 1., 1e-7);
  check::relative("long record, phase", result.phase_fit, M_PI / 2., 1e-6);
}

void test_first_maximum()
{
  // A ripple of 2 % of the range does not count, nor does the maximum at the start.
  const SignalAnalysis ripple =
      analyse(0., 1e-3, 1501,
              [](const double t)
              { return std::cos(2. * M_PI * t) + 0.02 * std::sin(2. * M_PI * 50. * t); });
  check::absolute("first maximum after a start at the top", ripple.time_of_first_maximum, 1., 0.02);
  const SignalAnalysis parabola =
      analyse(0., 0.3, 11, [](const double t) { return 4. - (t - 1.) * (t - 1.); });
  check::relative("parabola between samples", parabola.first_maximum, 4., 1e-12);
  check::relative("time of the parabola", parabola.time_of_maximum, 1., 1e-12);
  check::absolute("minimum at the end", parabola.minimum, 0., 1e-12);
  check::relative("time of the minimum", parabola.time_of_minimum, 3., 1e-12);
}

void test_no_oscillation()
{
  const SignalAnalysis constant = analyse(0., 0.1, 100, [](double) { return 0.3; });
  check::is_true("constant", no_oscillation(constant));
  check::is_true("values of a constant", constant.maximum == 0.3 && constant.minimum == 0.3 &&
                                             std::abs(constant.mean - 0.3) < 1e-15 &&
                                             std::abs(constant.root_mean_square - 0.3) < 1e-15);
  check::is_true("times of a constant", std::isnan(constant.time_of_maximum) &&
                                            std::isnan(constant.time_of_minimum) &&
                                            std::isnan(constant.first_maximum) &&
                                            std::isnan(constant.time_of_first_maximum));
  const SignalAnalysis ramp = analyse(0., 0.1, 100, [](const double t) { return 2. * t; });
  check::is_true("ramp", no_oscillation(ramp) && std::isnan(ramp.first_maximum));
  check::relative("mean of a ramp", ramp.mean, 9.9, 1e-12);
  check::is_true(
      "approach to a steady state",
      no_oscillation(analyse(0., 0.01, 1000, [](const double t) { return 1. - std::exp(-t); })));
  check::is_true("half a period",
                 no_oscillation(analyse(0., 0.01, 50,
                                        [](const double t) { return std::sin(2. * M_PI * t); })));
  unsigned int state = 1;
  const SignalAnalysis noise = analyse(0., 0.01, 1000,
                                       [&state](double)
                                       {
                                         state = 1664525u * state + 1013904223u;
                                         return state / 4294967296.;
                                       });
  check::is_true("noise is not fitted", std::isnan(noise.frequency_fit));
  const SignalAnalysis brief = analyse_signal({0., 1., 2.}, {0., 1., 0.});
  check::is_true("too short", no_oscillation(brief) && brief.maximum == 1.);
  check::is_true("one sample", std::isnan(analyse_signal({0.}, {1.}).mean));
  check::is_true("no sample", std::isnan(analyse_signal({}, {}).maximum));
  check::is_true(
      "not finite",
      std::isnan(
          analyse_signal({0., 1., 2.}, {0., std::numeric_limits<double>::infinity(), 0.}).minimum));
  check::throws<std::invalid_argument>(
      "times",
      []() {
        analyse_signal({0., 0.}, {1., 2.});
      },
      "increase");
  check::throws<std::invalid_argument>(
      "lengths",
      []() {
        analyse_signal({0., 1.}, {1.});
      },
      "as many");
}
} // namespace

UNIT_TEST(signal_analysis)
{
  test_sine();
  test_step_load();
  test_modes();
  test_long_record();
  test_first_maximum();
  test_no_oscillation();
}
} // namespace test_of_signal_analysis
