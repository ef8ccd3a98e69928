#include <continua/signal/beat_values.h>

#include <continua/base/undefined.h>
#include <continua/signal/first_pulse.h>
#include <continua/signal/up_crossings.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
BeatValues beat_values(const std::vector<double> &times,
                       const std::vector<double> &values,
                       const std::size_t n_intervals,
                       const std::size_t number,
                       const bool jumps_at_start)
{
  if (number == 0 || n_intervals == 0 || times.size() != values.size() ||
      values.size() <= number * n_intervals)
    throw std::invalid_argument("the history does not have this beat");
  const std::size_t begin = (number - 1) * n_intervals;
  const auto part = [&](const std::vector<double> &all)
  { return std::vector<double>(all.begin() + begin, all.begin() + begin + n_intervals + 1); };
  const std::vector<double> beat = part(values), beat_times = part(times);
  BeatValues result = {undefined, undefined, undefined, undefined, undefined};
  if (std::any_of(beat.begin(), beat.end(),
                  [](const double value) { return !std::isfinite(value); }))
    return result;
  const auto [smallest, largest] = std::minmax_element(beat.begin(), beat.end());
  result.largest = refine_extremum(beat_times, beat, largest - beat.begin()).value;
  result.smallest = refine_extremum(beat_times, beat, smallest - beat.begin()).value;
  result.range = result.largest - result.smallest;
  result.mean = average_signal(beat_times, beat, beat_times.front(), beat_times.back()).mean;
  if (number == 1)
    return result;
  double difference = 0.;
  for (std::size_t i = number == 2 && jumps_at_start ? 1 : 0; i <= n_intervals; ++i)
    difference = std::max(difference, std::abs(beat[i] - values[begin - n_intervals + i]));
  // A history that does not vary at all has not changed, or has changed without measure.
  result.difference = difference == 0. ? 0. : difference / result.range;
  return result;
}
} // namespace Continua
