// First pulses whose peak, half-height and foot are known: a triangle, a sine squared, with another
// level before it; what is no pulse, and one that a second one overtakes.

#include <continua/signal/first_pulse.h>

#include "../unit_test.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace test_of_first_pulse
{
namespace
{
using namespace Continua;

struct History
{
  History(const std::function<double(double)> &function,
          const double begin,
          const double end,
          const double interval)
  {
    for (unsigned int i = 0; begin + i * interval < end + 0.5 * interval; ++i)
    {
      times.push_back(begin + i * interval);
      values.push_back(function(times.back()));
    }
  }
  FirstPulse pulse() const { return find_first_pulse(times, values); }

  std::vector<double> times, values;
};

/// Straight up to 1 at t = 1 and down again.
double triangle(const double t)
{
  return std::max(0., 1. - std::abs(t - 1.));
}

bool is_none(const FirstPulse &pulse)
{
  return std::isnan(pulse.peak_time) && std::isnan(pulse.amplitude) && std::isnan(pulse.level) &&
         std::isnan(pulse.half_time) && std::isnan(pulse.tangent_foot_time) && !pulse.has_fallen;
}
} // namespace

UNIT_TEST(first_pulse)
{
  {
    // 5 - 3 (t - 0.37)^2 at times that are not equally far apart.
    const std::vector<double> times = {0., 0.2, 0.35, 0.6, 0.7};
    std::vector<double> values;
    for (const double t : times)
      values.push_back(5. - 3. * (t - 0.37) * (t - 0.37));
    const Vertex vertex = refine_extremum(times, values, 2);
    check::absolute("parabola: time", vertex.time, 0.37, 1e-14);
    check::absolute("parabola: value", vertex.value, 5., 1e-14);
    const Vertex first = refine_extremum(times, values, 0),
                 last = refine_extremum(times, values, 4);
    check::is_true("at the ends the sample", first.time == 0. && first.value == values[0] &&
                                                 last.time == 0.7 && last.value == values[4]);
    const Vertex straight = refine_extremum({0., 1., 2.}, {1., 2., 3.}, 1);
    check::is_true("a straight line: the sample", straight.time == 1. && straight.value == 2.);
  }
  {
    const FirstPulse pulse = History(triangle, -2., 4., 0.125).pulse();
    check::absolute("triangle: peak", pulse.peak_time, 1., 1e-14);
    check::absolute("triangle: amplitude", pulse.amplitude, 1., 1e-14);
    check::absolute("triangle: half-height", pulse.half_time, 0.5, 1e-14);
    check::absolute("triangle: rise", pulse.rise_time(), 0.5, 1e-14);
    check::absolute("triangle: level", pulse.level, 0., 0.);
    check::is_true("triangle: falls", pulse.has_fallen);
    // All values are above the first one.
    const FirstPulse raised =
        History([](const double t) { return 7. + 3. * triangle(t); }, -2., 4., 0.125).pulse();
    check::absolute("raised: amplitude", raised.amplitude, 3., 1e-14);
    check::absolute("raised: half-height", raised.half_time, 0.5, 1e-14);
  }
  {
    // A sin^2(pi (t - 0.1)/T): half as high after T/4, where it is steepest with pi A/T.
    const double length = 0.05;
    const auto pulse_at = [length](const double t)
    {
      return t < 0.1 || t > 0.1 + length ? 0.
                                         : 1e3 * std::pow(std::sin(M_PI * (t - 0.1) / length), 2);
    };
    const FirstPulse pulse = History(pulse_at, 0., 0.3, 1.3e-4).pulse();
    check::absolute("sine: peak", pulse.peak_time, 0.1 + 0.5 * length, 1e-6);
    check::relative("sine: amplitude", pulse.amplitude, 1e3, 1e-6);
    check::absolute("sine: half-height", pulse.half_time, 0.1 + 0.25 * length, 1e-6);
    check::absolute("sine: foot", pulse.tangent_foot_time, 0.1 + length * (0.25 - 0.5 / M_PI),
                    2e-6);
    // A forerunner of 100 comes long before and stays: the level, from which the height counts.
    const FirstPulse ahead =
        History([&](const double t) { return pulse_at(t) + (t > 0.02 ? 100. : 0.); }, 0., 0.3,
                1.3e-4)
            .pulse();
    check::absolute("forerunner: level", ahead.level, 100., 1e-9);
    check::relative("forerunner: amplitude", ahead.amplitude, 1100., 1e-6);
    check::absolute("forerunner: half-height", ahead.half_time, 0.1 + 0.25 * length, 1e-6);
  }
  {
    // After the triangle, which falls to a half, the next one of the same height: they overlap.
    const FirstPulse pulse =
        History([](const double t) { return std::max(triangle(t), triangle(t - 1.)); }, -2., 4.,
                0.125)
            .pulse();
    check::absolute("overtaken: peak", pulse.peak_time, 1., 1e-14);
    check::is_true("overtaken: has not fallen", !pulse.has_fallen);
    // What is less than a quarter of all that comes is no pulse.
    const auto hump = [](const double height)
    {
      return History([height](const double t) { return height * triangle(t) + triangle(t - 3.); },
                     -2., 6., 0.125)
          .pulse();
    };
    check::absolute("a hump of 20 %: the next", hump(0.2).peak_time, 4., 1e-14);
    check::absolute("one of 30 % is a pulse", hump(0.3).peak_time, 1., 1e-14);
  }
  check::is_true("constant: none",
                 is_none(History([](double) { return 5.; }, 0., 1., 0.1).pulse()));
  check::is_true("rising: none", is_none(History([](double t) { return t; }, 0., 1., 0.1).pulse()));
  check::is_true("falling: none",
                 is_none(History([](double t) { return -t; }, 0., 1., 0.1).pulse()));
  check::is_true("two samples: none", is_none(find_first_pulse({0., 1.}, {0., 1.})));
  std::vector<double> values = History(triangle, -2., 4., 0.125).values;
  values[3] = std::numeric_limits<double>::quiet_NaN();
  check::is_true("not a number: none",
                 is_none(find_first_pulse(History(triangle, -2., 4., 0.125).times, values)));
}
} // namespace test_of_first_pulse
