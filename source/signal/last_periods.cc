#include <continua/signal/last_periods.h>

#include <continua/base/undefined.h>
#include <continua/signal/first_pulse.h>
#include <continua/signal/up_crossings.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
/// The part of the range beyond which a signal has crossed its mean.
constexpr double crossing_margin = 0.05;
/// Of the mean period: how long one of them may be, and what may follow the last one.
constexpr double longest_period = 1.2, longest_rest = 1.5;

/// A record from a sample on.
struct Tail
{
  std::vector<double> times, values;

  Tail(const std::vector<double> &all_times,
       const std::vector<double> &all_values,
       const double start)
  {
    const auto first = std::lower_bound(all_times.begin(), all_times.end(), start);
    times.assign(first, all_times.end());
    values.assign(all_values.begin() + (first - all_times.begin()), all_values.end());
  }
};

struct Extrema
{
  double smallest = HUGE_VAL, largest = -HUGE_VAL;
};

/// Between two times.
Extrema extrema(const Tail &tail, const double start, const double end)
{
  Extrema found;
  for (std::size_t i = 0; i < tail.times.size(); ++i)
  {
    if (tail.times[i] < start || tail.times[i] > end)
      continue;
    const bool is_interior = i > 0 && i + 1 < tail.times.size();
    const bool is_extremum =
        is_interior &&
        (tail.values[i] - tail.values[i - 1]) * (tail.values[i + 1] - tail.values[i]) <= 0.;
    const double value =
        is_extremum ? refine_extremum(tail.times, tail.values, i).value : tail.values[i];
    found.smallest = std::min(found.smallest, value);
    found.largest = std::max(found.largest, value);
  }
  return found;
}

/// The last n + 1 crossings of the mean of these n periods; none if they are no periods.
std::vector<double> last_crossings(const Tail &tail, const unsigned int n_periods)
{
  double start = tail.times.front(), end = tail.times.back(), mean = 0.;
  std::vector<double> crossings;
  for (unsigned int round = 0; round < 20; ++round)
  {
    const double previous = mean;
    mean = average_signal(tail.times, tail.values, start, end).mean;
    const Extrema range_of = extrema(tail, start, end);
    const double range = range_of.largest - range_of.smallest;
    crossings = find_up_crossings(tail.times, tail.values, mean, crossing_margin * range);
    if (!(range > 0.) || crossings.size() <= n_periods)
      return {};
    crossings.erase(crossings.begin(), crossings.end() - (n_periods + 1));
    if (round > 0 && std::abs(mean - previous) < 1e-12 * range)
      break;
    start = crossings.front();
    end = crossings.back();
  }
  const double period = (crossings.back() - crossings.front()) / n_periods;
  for (unsigned int i = 0; i < n_periods; ++i)
    if (crossings[i + 1] - crossings[i] > longest_period * period)
      return {};
  if (tail.times.back() - crossings.back() > longest_rest * period)
    return {};
  return crossings;
}
} // namespace

LastPeriods analyse_last_periods(const std::vector<double> &times,
                                 const std::vector<double> &values,
                                 const unsigned int n_periods)
{
  if (times.size() != values.size())
    throw std::invalid_argument("a signal needs as many times as values");
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(times[i] > times[i - 1]))
      throw std::invalid_argument("the times of a signal must increase");
  if (n_periods == 0)
    throw std::invalid_argument("there is nothing to say of no period");

  const LastPeriods none = {undefined, undefined, undefined, undefined,
                            undefined, undefined, undefined};
  if (!std::all_of(values.begin(), values.end(),
                   [](const double value) { return std::isfinite(value); }))
    return none;
  // Two samples a period are the least.
  for (double part = 1.; times.size() * part > 2. * n_periods; part *= 0.5)
  {
    const Tail tail(times, values, times.back() - part * (times.back() - times.front()));
    if (tail.times.size() < 3)
      break;
    const std::vector<double> crossings = last_crossings(tail, n_periods);
    if (crossings.empty())
      continue;
    LastPeriods result = none;
    result.start = crossings.front();
    result.end = crossings.back();
    result.mean = average_signal(tail.times, tail.values, result.start, result.end).mean;
    result.frequency = n_periods / (result.end - result.start);
    const auto amplitude = [&tail](const double start, const double end)
    {
      const Extrema found = extrema(tail, start, end);
      return 0.5 * (found.largest - found.smallest);
    };
    const Extrema found = extrema(tail, result.start, result.end);
    result.middle = 0.5 * (found.largest + found.smallest);
    result.amplitude = amplitude(result.start, result.end);
    if (n_periods > 1)
      result.change_of_amplitude = (amplitude(crossings[n_periods - n_periods / 2], result.end) -
                                    amplitude(result.start, crossings[n_periods / 2])) /
                                   result.amplitude;
    return result;
  }
  return none;
}
} // namespace Continua
