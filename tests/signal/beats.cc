// Beats of a load: pulses, a sine, a notch, noise; where the second one begins.

#include <continua/signal/beats.h>

#include "../unit_test.h"

#include <cmath>
#include <functional>

namespace test_of_beats
{
using namespace Continua;

namespace
{
constexpr double pi = 3.14159265358979323846;

/// Of a function of the time from 0 to 1 in 1000 samples.
Beats of(const std::function<double(double)> &function)
{
  std::vector<double> values;
  for (unsigned int i = 0; i < 1000; ++i)
    values.push_back(function(i / 1000.));
  return find_beats(values);
}

/// sin^2 of the length 0.1 from `start` on.
double pulse(const double time, const double start)
{
  const double phase = (time - start) / 0.1;
  return phase > 0. && phase < 1. ? std::pow(std::sin(pi * phase), 2) : 0.;
}
} // namespace

UNIT_TEST(beats)
{
  const Beats one = of([](const double t) { return 5. + pulse(t, 0.); });
  check::is_true("one pulse", one.number == 1 && one.second_begins == 1000);
  // The last sample of 0 before the second pulse; a hundredth is reached 3.2 samples later.
  const Beats two = of([](const double t) { return pulse(t, 0.) + 0.8 * pulse(t, 0.3); });
  check::is_true("two pulses", two.number == 2);
  check::absolute("the second begins", two.second_begins, 303., 1.);
  const Beats sine = of([](const double t) { return std::sin(2. * pi * 4. * t); });
  check::is_true("four periods", sine.number == 4);
  // The least value at 0.1875.
  check::absolute("the second period", sine.second_begins, 195., 2.);
  const Beats echo = of([](const double t) { return pulse(t, 0.) + 0.6 * pulse(t, 0.3); });
  check::is_true("a lower pulse is none", echo.number == 1);
  const Beats notch =
      of([](const double t) { return pulse(t, 0.) + 0.5 * pulse(t, 0.07) + pulse(t, 0.5); });
  check::is_true("a notch is none", notch.number == 2);
  const Beats noise =
      of([](const double t) { return t > 0.2 ? 1. : 5. * t + 0.1 * std::sin(1000. * t); });
  check::is_true("noise is none", noise.number == 1);
  check::is_true("a step", of([](const double t) { return t < 0.1 ? 0. : 1.; }).number == 1);
  check::is_true("at the start", of([](const double t) { return t < 0.1 ? 1. : 0.; }).number == 1);
  check::is_true("no load", of([](double) { return 3.; }).number == 0);
  check::is_true("no sample", find_beats({}).number == 0);
}
} // namespace test_of_beats
