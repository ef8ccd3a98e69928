#include <continua/signal/first_pulse.h>

#include <continua/base/undefined.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
/// A first pulse is higher than this part of all that comes; twice over a closed end with a margin.
constexpr double least_height = 0.25;
/// A maximum is followed by a fall of this part of itself.
constexpr double least_fall = 0.05;
/// A pulse that a reflection has not reached falls below this part of its height.
constexpr double fallen = 0.15;
/// The level before is the mean between these numbers of rise times before half-height.
constexpr double level_begin = 3.;
constexpr double level_end = 1.5;

/// The highest sample of the first pulse; the number of samples if there is none.
std::size_t find_peak(const std::vector<double> &values)
{
  const double largest = *std::max_element(values.begin(), values.end());
  std::size_t highest = 0;
  for (std::size_t i = 1; largest > 0. && i < values.size(); ++i)
  {
    if (values[i] > values[highest])
      highest = i;
    else if (values[highest] > least_height * largest &&
             values[i] < (1. - least_fall) * values[highest])
      return highest;
  }
  return values.size();
}

/// When the rise to the sample `peak` last goes through `level` before it; NaN if it never does.
double rise_through(const std::vector<double> &times,
                    const std::vector<double> &values,
                    const std::size_t peak,
                    const double level)
{
  for (std::size_t i = peak; i > 0; --i)
    if (values[i - 1] < level && values[i] >= level)
      return times[i - 1] +
             (level - values[i - 1]) * (times[i] - times[i - 1]) / (values[i] - values[i - 1]);
  return undefined;
}

/// The mean of the samples between two times; the first sample (0) if there is none.
double mean_between(const std::vector<double> &times,
                    const std::vector<double> &values,
                    const double begin,
                    const double end)
{
  double sum = 0.;
  unsigned int n = 0;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (times[i] >= begin && times[i] <= end)
    {
      sum += values[i];
      ++n;
    }
  return n > 0 ? sum / n : 0.;
}

/// Where the tangent of the steepest rise between two times meets `level`.
double tangent_foot(const std::vector<double> &times,
                    const std::vector<double> &values,
                    const double begin,
                    const std::size_t peak,
                    const double level)
{
  std::vector<double> middles, slopes;
  for (std::size_t i = 1; i <= peak; ++i)
  {
    middles.push_back(0.5 * (times[i - 1] + times[i]));
    slopes.push_back((values[i] - values[i - 1]) / (times[i] - times[i - 1]));
  }
  std::size_t steepest = slopes.size();
  for (std::size_t i = 0; i < slopes.size(); ++i)
    if (times[i] >= begin && (steepest == slopes.size() || slopes[i] > slopes[steepest]))
      steepest = i;
  if (steepest == slopes.size() || slopes[steepest] <= 0.)
    return undefined;
  const Vertex vertex = refine_extremum(middles, slopes, steepest);
  // The pressure there, by the chord of the interval and the change of slope across it.
  const double value =
      values[steepest] +
      slopes[steepest] *
          (std::clamp(vertex.time, times[steepest], times[steepest + 1]) - times[steepest]);
  return std::clamp(vertex.time, times[steepest], times[steepest + 1]) -
         (value - level) / vertex.value;
}

/// Whether the values after the peak fall below `threshold` before they rise by `margin`.
bool falls_below(const std::vector<double> &values,
                 const std::size_t peak,
                 const double threshold,
                 const double margin)
{
  double lowest = values[peak];
  for (std::size_t i = peak + 1; i < values.size(); ++i)
  {
    lowest = std::min(lowest, values[i]);
    if (lowest < threshold)
      return true;
    if (values[i] > lowest + margin)
      return false;
  }
  return false;
}
} // namespace

Vertex refine_extremum(const std::vector<double> &times,
                       const std::vector<double> &values,
                       const std::size_t i)
{
  if (i == 0 || i + 1 >= times.size())
    return {times[i], values[i]};
  const double before = times[i] - times[i - 1];
  const double after = times[i + 1] - times[i];
  const double slope_before = (values[i] - values[i - 1]) / before;
  const double slope_after = (values[i + 1] - values[i]) / after;
  const double curvature = 2. * (slope_after - slope_before) / (before + after);
  if (curvature == 0.)
    return {times[i], values[i]};
  const double slope = (slope_before * after + slope_after * before) / (before + after);
  const double shift = -slope / curvature;
  return {times[i] + shift, values[i] + 0.5 * slope * shift};
}

FirstPulse find_first_pulse(const std::vector<double> &times, const std::vector<double> &values)
{
  const FirstPulse none = {undefined, undefined, undefined, undefined, undefined, false};
  if (times.size() < 3 || std::any_of(values.begin(), values.end(),
                                      [](const double value) { return !std::isfinite(value); }))
    return none;
  std::vector<double> above(values);
  for (double &value : above)
    value -= values.front();
  const std::size_t peak = find_peak(above);
  if (peak == above.size())
    return none;

  FirstPulse pulse = none;
  const Vertex vertex = refine_extremum(times, above, peak);
  pulse.peak_time = vertex.time;
  pulse.amplitude = vertex.value;
  // The level is told by the time at half-height and that by the level.
  pulse.level = 0.;
  for (unsigned int round = 0; round < 4; ++round)
  {
    pulse.half_time = rise_through(times, above, peak, 0.5 * (pulse.level + pulse.amplitude));
    if (!std::isfinite(pulse.half_time))
      return none;
    pulse.level = mean_between(times, above, pulse.half_time - level_begin * pulse.rise_time(),
                               pulse.half_time - level_end * pulse.rise_time());
  }
  pulse.tangent_foot_time = tangent_foot(
      times, above, pulse.half_time - level_end * pulse.rise_time(), peak, pulse.level);
  const double height = pulse.amplitude - pulse.level;
  pulse.has_fallen = falls_below(above, peak, pulse.level + fallen * height, least_fall * height);
  return pulse;
}
} // namespace Continua
