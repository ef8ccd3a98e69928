// What a history does in its beats: a sine that has settled, one that grows, a decay, a constant.

#include <continua/signal/beat_values.h>

#include "../unit_test.h"

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace test_of_beat_values
{
using namespace Continua;

namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr std::size_t n_intervals = 40;

/// Beats of 0.8 s, of a function of the time.
BeatValues of(const std::function<double(double)> &function,
              const std::size_t number,
              const bool jumps_at_start = false)
{
  std::vector<double> times, values;
  for (std::size_t i = 0; i <= 3 * n_intervals; ++i)
  {
    times.push_back(0.8 * i / n_intervals);
    values.push_back(function(times.back()));
  }
  return beat_values(times, values, n_intervals, number, jumps_at_start);
}
} // namespace

UNIT_TEST(beat_values)
{
  const auto sine = [](const double t) { return 5. + 2. * std::sin(2. * pi * t / 0.8 + 0.1); };
  const BeatValues settled = of(sine, 3);
  // The parabola through three of 40 samples is off by less than 1e-4 of the amplitude.
  check::absolute("largest", settled.largest, 7., 2e-4);
  check::absolute("smallest", settled.smallest, 3., 2e-4);
  check::absolute("mean", settled.mean, 5., 1e-12);
  check::absolute("range", settled.range, 4., 4e-4);
  check::absolute("it has settled", settled.difference, 0., 1e-12);
  check::is_true("nothing before the first", std::isnan(of(sine, 1).difference));

  // Grows by 0.3 a beat.
  const auto growing = [&](const double t) { return sine(t) + 0.3 * t / 0.8; };
  check::absolute("mean of one that grows", of(growing, 2).mean, 5. + 0.45, 1e-12);
  check::relative("difference of one that grows", of(growing, 2).difference,
                  0.3 / of(growing, 2).range, 1e-12);
  // The difference of a decay is largest at the start of the beat.
  const auto decay = [](const double t) { return std::exp(-t / 0.4); };
  check::relative("difference of a decay", of(decay, 3).difference,
                  (std::exp(-2.) - std::exp(-4.)) / (std::exp(-4.) - std::exp(-6.)), 1e-12);

  // A first sample from before a jump of the loads: not compared, and in no later beat.
  const auto jump = [&](const double t) { return t == 0. ? 10. : growing(t); };
  check::is_true("a jump at the start", of(jump, 2).difference > 1.);
  check::relative("a jump at the start that is left out", of(jump, 2, true).difference,
                  of(growing, 2).difference, 1e-12);
  check::relative("of later beats nothing is left out", of(decay, 3, true).difference,
                  of(decay, 3).difference, 1e-12);

  check::absolute("a constant has settled", of([](double) { return 3.; }, 2).difference, 0., 0.);
  check::is_true("steps of a constant have not",
                 std::isinf(of([](const double t) { return t < 0.7999 ? 1. : 2.; }, 2).difference));
  check::is_true("a value that is not there",
                 std::isnan(of([](const double t)
                               { return t > 1. ? std::numeric_limits<double>::quiet_NaN() : t; },
                               2)
                                .mean));
  check::throws<std::invalid_argument>(
      "a beat that is not there", [&]() { of(sine, 4); }, "does not have this beat");
}
} // namespace test_of_beat_values
