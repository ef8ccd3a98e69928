// What is a jump in an interval and what is merely steep.

#include "../unit_test.h"

#include <continua/signal/jump.h>

#include <cmath>

namespace test_of_jump
{
using namespace Continua;

UNIT_TEST(jump)
{
  const auto step_at = [](const double place)
  { return [place](const double t) { return t < place ? 0. : 1.; }; };
  check::is_true("a step inside the interval", jumps_within(step_at(0.3), 0., 1.));
  check::is_true("a step near its end", jumps_within(step_at(0.999), 0., 1.));
  check::is_true("a step at its begin", jumps_within(step_at(0.), -1e-6, 1.));
  check::is_true("a step outside", !jumps_within(step_at(1.5), 0., 1.));
  check::is_true("a step on a large offset is found by its size",
                 jumps_within([](const double t) { return t < 0.4 ? 10. : 11.; }, 0., 1.));
  check::is_true(
      "a sine that is zero at both ends",
      !jumps_within([](const double t) { return 100. * std::sin(1000. * M_PI * t); }, 0., 1e-3));
  check::is_true("a pulse that starts with a kink",
                 !jumps_within([](const double t) { return t < 0.5 ? 0. : t - 0.5; }, 0., 1.));
  // At 0.05 s the square of the sine is 1e-32, not 0.
  check::is_true(
      "the smooth end of a pulse",
      !jumps_within([](const double t)
                    { return t <= 0.05 ? 1e3 * std::pow(std::sin(M_PI * t / 0.05), 2) : 0.; },
                    0.05, 0.0502));
  // Begins within the last part that is looked at; one interval later it is a million times larger.
  check::is_true("the smooth begin of a pulse",
                 !jumps_within([](const double t)
                               { return t > 0.9999999 ? std::pow(t - 0.9999999, 2) : 0.; },
                               0., 1.));
  for (const double level : {13300., -13300., 1e6})
    check::is_true(
        "a small step on a mean of " + std::to_string(level),
        jumps_within([level](const double t) { return level + (t < 0.4 ? 0. : 100.); }, 0., 1.));
  check::is_true("a step of a millionth of the mean",
                 jumps_within([](const double t) { return t < 0.4 ? 1e3 : 1e3 + 1e-3; }, 0., 1.));
  check::is_true(
      "a slow wave on a mean",
      !jumps_within([](const double t) { return 13300. + 1e-3 * std::cos(t); }, 0., 1e-3));
  check::is_true(
      "round-off of a constant",
      !jumps_within([](const double t) { return 13300. + 3e-12 * std::sin(1e9 * t); }, 0., 1.));
  check::is_true("a constant", !jumps_within([](double) { return 3.; }, 0., 1.));
}
} // namespace test_of_jump
