#include "../unit_test.h"

#include <continua/signal/last_periods.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

namespace test_of_last_periods
{
using namespace Continua;

namespace
{
LastPeriods analyse_last(const double step,
                         const double end,
                         const unsigned int n_periods,
                         const std::function<double(double)> &function)
{
  std::vector<double> times, values;
  for (unsigned int i = 0; i * step <= end; ++i)
  {
    times.push_back(i * step);
    values.push_back(function(times.back()));
  }
  return analyse_last_periods(times, values, n_periods);
}

/// A force that a flow exerts: it starts, becomes unstable, and swings about a mean that is large
/// against its amplitude.
double settling_force(const double time)
{
  const double ramp = time < 2. ? 0.5 * (1. - std::cos(M_PI * time / 2.)) : 1.;
  return 440. * ramp + 5.6 * std::sin(2. * M_PI * 4.4 * time) / (1. + std::exp(-4. * (time - 4.)));
}

void test_settled()
{
  const LastPeriods last = analyse_last(5e-3, 10., 10, settling_force);
  check::relative("settled, mean", last.mean, 440., 1e-6);
  check::relative("settled, middle", last.middle, 440., 1e-6);
  check::relative("settled, amplitude", last.amplitude, 5.6, 1e-4);
  check::relative("settled, frequency", last.frequency, 4.4, 1e-5);
  check::absolute("settled, change of amplitude", last.change_of_amplitude, 0., 1e-4);
  check::relative("settled, length", last.end - last.start, 10. / 4.4, 1e-5);
  check::is_true("settled, at the end", last.end > 10. - 1.1 / 4.4 && last.end <= 10.);
}

void test_two_frequencies()
{
  // Mean and middle differ: cos x + cos 2x / 2 lies between -3/4 and 3/2.
  const LastPeriods last = analyse_last(1e-3, 3.1, 3,
                                        [](const double t)
                                        {
                                          const double x = 2. * M_PI * 2. * t;
                                          return std::cos(x) + 0.5 * std::cos(2. * x);
                                        });
  check::absolute("two frequencies, mean", last.mean, 0., 1e-5);
  check::relative("two frequencies, middle", last.middle, 0.375, 1e-5);
  check::relative("two frequencies, amplitude", last.amplitude, 1.125, 1e-5);
  check::relative("two frequencies, frequency", last.frequency, 2., 1e-6);
}

void test_change()
{
  // Over n periods exp(d t) grows by exp(n d T): the two halves of four differ by exp(2 d T), and
  // the amplitude of all four is the larger one.
  const double period = 0.5;
  for (const double rate : {0.1, -0.1})
  {
    const std::string name = rate > 0. ? "growing" : "decaying";
    const LastPeriods last = analyse_last(
        1e-3, 10., 4, [=](const double t) { return std::exp(rate * t) * std::sin(4. * M_PI * t); });
    const double ratio = std::exp(-2. * std::abs(rate) * period);
    check::relative(name + ", change of amplitude", last.change_of_amplitude,
                    rate > 0. ? 1. - ratio : ratio - 1., 0.02);
    check::relative(name + ", frequency", last.frequency, 2., 1e-3);
  }
}

void test_without_periods()
{
  const auto sine = [](const double t) { return std::sin(2. * M_PI * t); };
  check::is_true("too few periods", std::isnan(analyse_last(1e-2, 3.2, 4, sine).frequency));
  check::relative("enough of them", analyse_last(1e-2, 5.2, 4, sine).frequency, 1., 1e-4);
  check::is_true(
      "at rest at the end",
      std::isnan(analyse_last(1e-2, 20., 3, [&](const double t) { return t < 10. ? sine(t) : 0.; })
                     .frequency));
  // The frequency trebles before the end: the last of three periods is shorter.
  check::is_true(
      "of different length",
      std::isnan(analyse_last(1e-3, 4.4, 3,
                              [&](const double t) { return t < 4. ? sine(t) : sine(3. * t); })
                     .frequency));
  check::is_true("a constant",
                 std::isnan(analyse_last(1e-2, 3., 1, [](double) { return 2.; }).mean));
  check::is_true("one period has no change",
                 std::isnan(analyse_last(1e-2, 3.2, 1, sine).change_of_amplitude));
  check::throws<std::invalid_argument>(
      "no period", [&]() { analyse_last(1e-2, 3., 0, sine); }, "no period");
  check::throws<std::invalid_argument>(
      "times",
      []() {
        analyse_last_periods({0., 0.}, {1., 2.}, 1);
      },
      "increase");
  check::throws<std::invalid_argument>(
      "lengths",
      []() {
        analyse_last_periods({0., 1.}, {1.}, 1);
      },
      "as many");
}
} // namespace

UNIT_TEST(last_periods)
{
  test_settled();
  test_two_frequencies();
  test_change();
  test_without_periods();
}
} // namespace test_of_last_periods
