#include <continua/signal/signal_analysis.h>

#include <continua/base/undefined.h>
#include <continua/signal/up_crossings.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
/// The part of the range that a change must have to be one of the signal, not noise or a higher
/// mode.
constexpr double significant = 0.05;

struct Record
{
  const std::vector<double> &times;
  const std::vector<double> &values;

  std::size_t size() const { return times.size(); }
};

struct Extremum
{
  double time, value;
};

/// The vertex of the parabola through sample i, an extremum, and its neighbours.
Extremum refine(const Record &record, const std::size_t i)
{
  if (i == 0 || i + 1 == record.size())
    return {record.times[i], record.values[i]};
  const double before = record.times[i] - record.times[i - 1];
  const double after = record.times[i + 1] - record.times[i];
  const double slope_before = (record.values[i] - record.values[i - 1]) / before;
  const double slope_after = (record.values[i + 1] - record.values[i]) / after;
  const double curvature = 2. * (slope_after - slope_before) / (before + after);
  if (curvature == 0.)
    return {record.times[i], record.values[i]};
  const double slope = (slope_before * after + slope_after * before) / (before + after);
  const double shift = -slope / curvature;
  return {record.times[i] + shift, record.values[i] + 0.5 * slope * shift};
}

Extremum find_first_maximum(const Record &record, const double range)
{
  double lowest = record.values[0];
  bool risen = false;
  std::size_t highest = 0;
  for (std::size_t i = 1; i < record.size(); ++i)
  {
    const double value = record.values[i];
    if (risen)
    {
      if (value > record.values[highest])
        highest = i;
      else if (value < record.values[highest] - significant * range)
        return refine(record, highest);
    }
    else if (value > lowest + significant * range)
    {
      risen = true;
      highest = i;
    }
    else
      lowest = std::min(lowest, value);
  }
  return {undefined, undefined};
}

void analyse_periods(const Record &record, const double range, SignalAnalysis &result)
{
  SignalAverages averages =
      average_signal(record.times, record.values, record.times.front(), record.times.back());
  // The mean defines the crossings and they the span of the mean: a few rounds suffice.
  for (unsigned int round = 0; range > 0. && round < 20; ++round)
  {
    const std::vector<double> crossings =
        find_up_crossings(record.times, record.values, averages.mean, significant * range);
    if (crossings.size() < 2)
      break;
    const double previous = averages.mean;
    averages = average_signal(record.times, record.values, crossings.front(), crossings.back());
    result.frequency_zero_crossings =
        (crossings.size() - 1) / (crossings.back() - crossings.front());
    if (std::abs(averages.mean - previous) < 1e-12 * range)
      break;
  }
  result.mean = averages.mean;
  result.root_mean_square = std::sqrt(averages.mean_square);
}

void analyse_fit(const Record &record, SignalAnalysis &result)
{
  const double duration = record.times.back() - record.times.front();
  std::vector<double> starts;
  if (std::isfinite(result.frequency_zero_crossings))
    starts = {result.frequency_zero_crossings};
  else
    for (const double n_periods : {1., 1.5, 2., 3.})
      starts.push_back(n_periods / duration);

  DampedSineFit best;
  best.explained = 0.5;
  best.converged = false;
  for (const double start : starts)
  {
    const DampedSineFit fit = fit_damped_sines(record.times, record.values, {start});
    if (fit.converged && fit.components[0].frequency * duration >= 1. &&
        fit.explained >= best.explained)
      best = fit;
  }
  if (!best.converged)
    return;
  const DampedSine &sine = best.components[0];
  result.frequency_fit = sine.frequency;
  result.decay_per_oscillation_fit = std::exp(-sine.decay_rate / sine.frequency);
  result.amplitude_fit = sine.amplitude;
  result.offset_fit = best.offset;
  result.phase_fit = sine.phase;
  result.fit_residual = best.residual;
}
} // namespace

SignalAnalysis analyse_signal(const std::vector<double> &times, const std::vector<double> &values)
{
  if (times.size() != values.size())
    throw std::invalid_argument("a signal needs as many times as values");
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(times[i] > times[i - 1]))
      throw std::invalid_argument("the times of a signal must increase");

  SignalAnalysis result;
  for (double *const value :
       {&result.maximum, &result.minimum, &result.time_of_maximum, &result.time_of_minimum,
        &result.first_maximum, &result.time_of_first_maximum, &result.mean,
        &result.root_mean_square, &result.frequency_zero_crossings, &result.frequency_fit,
        &result.decay_per_oscillation_fit, &result.amplitude_fit, &result.offset_fit,
        &result.phase_fit, &result.fit_residual})
    *value = undefined;
  if (values.empty() || !std::all_of(values.begin(), values.end(),
                                     [](const double value) { return std::isfinite(value); }))
    return result;

  const Record record{times, values};
  const auto lowest = std::min_element(values.begin(), values.end());
  const auto highest = std::max_element(values.begin(), values.end());
  // A constant with round-off is a constant.
  const double difference = *highest - *lowest;
  const double magnitude = std::max(std::abs(*highest), std::abs(*lowest));
  const double range = difference > 1e-13 * magnitude ? difference : 0.;
  result.maximum = *highest;
  result.minimum = *lowest;
  if (values.size() < 2)
    return result;
  if (range > 0.)
  {
    const Extremum maximum = refine(record, highest - values.begin());
    const Extremum minimum = refine(record, lowest - values.begin());
    const Extremum first_maximum = find_first_maximum(record, range);
    result.maximum = maximum.value;
    result.time_of_maximum = maximum.time;
    result.minimum = minimum.value;
    result.time_of_minimum = minimum.time;
    result.first_maximum = first_maximum.value;
    result.time_of_first_maximum = first_maximum.time;
  }
  analyse_periods(record, range, result);
  if (range > 0.)
    analyse_fit(record, result);
  return result;
}
} // namespace Continua
