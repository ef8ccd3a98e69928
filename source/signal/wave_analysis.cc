#include <continua/base/undefined.h>
#include <continua/signal/first_pulse.h>
#include <continua/signal/fourier_transform.h>
#include <continua/signal/wave_analysis.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
constexpr ByArrival nothing = {undefined, undefined, undefined, undefined};
/// From one station to the next a pulse grows and widens by less than these factors.
constexpr double largest_growth = 1.25;
constexpr double largest_widening = 1.3;
/// The window of the phase: rise times before and after the peak, and its tapered parts.
constexpr double window_before = 4.;
constexpr double window_after = 2.5;
constexpr double taper = 0.15;
/// The part of the largest amplitude that bounds the pulse's bandwidth.
constexpr double bandwidth_level = 0.1;
/// A smaller reflection is the round-off of a wave that meets none.
constexpr double least_reflection = 1e-6;

void check(const WaveRecord &record)
{
  const std::size_t n = record.positions.size();
  const auto increase = [](const std::vector<double> &values)
  {
    return std::adjacent_find(values.begin(), values.end(),
                              [](const double a, const double b)
                              { return !(a < b); }) == values.end();
  };
  const auto complete = [&](const std::vector<std::vector<double>> &histories)
  {
    return histories.size() == n && std::all_of(histories.begin(), histories.end(),
                                                [&](const std::vector<double> &history)
                                                { return history.size() == record.times.size(); });
  };
  if (!complete(record.pressure))
    throw std::invalid_argument("a wave needs the pressure of every station at every time");
  if (!record.flow_rate.empty() &&
      (!complete(record.flow_rate) || record.characteristic_impedance.size() != n))
    throw std::invalid_argument(
        "a wave needs the flow rate and the characteristic impedance of every station, or of none");
  if (!increase(record.positions) || !increase(record.times))
    throw std::invalid_argument("the positions and times of a wave must increase");
}

/// The slope of y over x by least squares, of the pairs that are finite; NaN for fewer than two.
double slope(const std::vector<double> &x, const std::vector<double> &y)
{
  double n = 0., mean_x = 0., mean_y = 0.;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::isfinite(x[i]) && std::isfinite(y[i]))
    {
      n += 1.;
      mean_x += x[i];
      mean_y += y[i];
    }
  if (n < 2.)
    return undefined;
  mean_x /= n;
  mean_y /= n;
  double sum_xy = 0., sum_xx = 0.;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::isfinite(x[i]) && std::isfinite(y[i]))
    {
      sum_xy += (x[i] - mean_x) * (y[i] - mean_y);
      sum_xx += (x[i] - mean_x) * (x[i] - mean_x);
    }
  return sum_xx > 0. ? sum_xy / sum_xx : undefined;
}

/// The window of the phase at a time after the peak, in rise times.
double window(const double distance)
{
  const double length = window_before + window_after;
  const double place = (distance + window_before) / length;
  const double edge = std::min(place, 1. - place);
  if (edge <= 0.)
    return 0.;
  return edge >= taper ? 1. : 0.5 * (1. - std::cos(PI * edge / taper));
}

/// The transform of the pulse, on a uniform grid that begins at the record's first time.
std::vector<std::complex<double>> spectrum_of_pulse(const std::vector<double> &times,
                                                    const std::vector<double> &pressure,
                                                    const FirstPulse &pulse,
                                                    const double rise_time,
                                                    const double interval)
{
  const double duration = times.back() - times.front();
  const std::size_t n_inside = static_cast<std::size_t>(duration / interval) + 1;
  // As much again of zeros.
  std::vector<double> samples(next_power_of_two(2 * n_inside), 0.);
  std::size_t left = 0;
  for (std::size_t j = 0; j < n_inside; ++j)
  {
    const double time = times.front() + j * interval;
    const double weight = window((time - pulse.peak_time) / rise_time);
    if (weight == 0.)
      continue;
    while (left + 2 < times.size() && times[left + 1] < time)
      ++left;
    const double part = (time - times[left]) / (times[left + 1] - times[left]);
    const double value = (1. - part) * pressure[left] + part * pressure[left + 1];
    samples[j] = weight * (value - pressure.front() - pulse.level);
  }
  return fourier_transform(samples);
}

/// The delay of a pulse against the reference by the phase of their cross-spectrum [s].
double phase_delay(const std::vector<std::complex<double>> &reference,
                   const std::vector<std::complex<double>> &spectrum,
                   const double frequency_step,
                   const double peak_delay)
{
  double largest = 0.;
  for (const auto &value : reference)
    largest = std::max(largest, std::abs(value));
  // The phase that is left has no more than a part of a turn, so that it need not be unwrapped.
  double numerator = 0., denominator = 0.;
  for (std::size_t k = 1; k < reference.size(); ++k)
  {
    if (std::abs(reference[k]) < bandwidth_level * largest)
      break;
    const double angular_frequency = 2. * PI * k * frequency_step;
    const std::complex<double> cross =
        spectrum[k] * std::conj(reference[k]) * std::polar(1., angular_frequency * peak_delay);
    numerator -= std::abs(cross) * std::arg(cross) * angular_frequency;
    denominator += std::abs(cross) * angular_frequency * angular_frequency;
  }
  return denominator > 0. ? peak_delay + numerator / denominator : undefined;
}

void set_phases(const WaveRecord &record,
                const std::vector<FirstPulse> &pulses,
                std::vector<StationWave> &stations)
{
  // Of the smallest interval, so that nothing of the record is lost.
  double interval = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < record.times.size(); ++i)
    interval = std::min(interval, record.times[i] - record.times[i - 1]);
  const FirstPulse *first = nullptr;
  std::vector<std::complex<double>> reference;
  for (std::size_t i = 0; i < stations.size(); ++i)
  {
    const FirstPulse &pulse = pulses[i];
    if (!std::isfinite(pulse.peak_time) || !pulse.has_fallen)
      continue;
    const double rise_time = first == nullptr ? pulse.rise_time() : first->rise_time();
    if (pulse.peak_time + window_after * rise_time > record.times.back())
      continue;
    const auto spectrum =
        spectrum_of_pulse(record.times, record.pressure[i], pulse, rise_time, interval);
    if (first == nullptr)
    {
      first = &pulse;
      reference = spectrum;
      stations[i].arrival.phase = pulse.peak_time;
      continue;
    }
    const double frequency_step = 1. / (2. * (reference.size() - 1) * interval);
    stations[i].arrival.phase = first->peak_time + phase_delay(reference, spectrum, frequency_step,
                                                               pulse.peak_time - first->peak_time);
  }
}

double reflection(const std::vector<double> &times, const SeparatedWaves &waves)
{
  const FirstPulse forward = find_first_pulse(times, waves.forward);
  if (!std::isfinite(forward.peak_time))
    return undefined;
  // At the end of the tube the backward wave comes with the forward one, never before it.
  const double base = waves.backward.front();
  std::size_t first = 0;
  while (times[first] < forward.half_time)
    ++first;
  std::size_t largest = first;
  for (std::size_t i = first; i < times.size(); ++i)
    if (std::abs(waves.backward[i] - base) > std::abs(waves.backward[largest] - base))
      largest = i;
  // At an end of what is looked at there is no peak.
  if (largest == first || largest + 1 >= times.size())
    return undefined;
  const double ratio =
      (refine_extremum(times, waves.backward, largest).value - base) / forward.amplitude;
  return std::abs(ratio) < least_reflection ? undefined : ratio;
}
} // namespace

SeparatedWaves separate_waves(const std::vector<double> &pressure,
                              const std::vector<double> &flow_rate,
                              const double characteristic_impedance)
{
  if (pressure.size() != flow_rate.size())
    throw std::invalid_argument("the histories of pressure and flow rate are not equally long");
  SeparatedWaves waves;
  for (std::size_t i = 0; i < pressure.size(); ++i)
  {
    const double of_flow = characteristic_impedance * flow_rate[i];
    waves.forward.push_back(0.5 * (pressure[i] + of_flow));
    waves.backward.push_back(0.5 * (pressure[i] - of_flow));
  }
  return waves;
}

WaveAnalysis analyse_wave(const WaveRecord &record)
{
  check(record);
  const std::size_t n = record.positions.size();
  WaveAnalysis analysis{std::vector<StationWave>(n, {nothing, undefined, undefined, undefined, {}}),
                        nothing, undefined};
  std::vector<FirstPulse> pulses(n);
  const FirstPulse *previous = nullptr;
  bool overlaps = false;
  for (std::size_t i = 0; i < n; ++i)
  {
    FirstPulse &pulse = pulses[i] = find_first_pulse(record.times, record.pressure[i]);
    if (previous != nullptr && std::isfinite(pulse.peak_time))
      overlaps = overlaps || pulse.amplitude > largest_growth * previous->amplitude ||
                 pulse.rise_time() > largest_widening * previous->rise_time();
    if (overlaps)
      pulse = find_first_pulse({}, {});
    if (!std::isfinite(pulse.peak_time))
    {
      analysis.stations[i].missing = overlaps ? MissingPulse::overlaps : MissingPulse::no_peak;
      continue;
    }
    previous = &pulse;
    analysis.stations[i].arrival = {pulse.peak_time, pulse.half_time, pulse.tangent_foot_time,
                                    undefined};
    analysis.stations[i].amplitude = pulse.amplitude;
    analysis.stations[i].level = pulse.level;
  }
  set_phases(record, pulses, analysis.stations);
  if (!record.flow_rate.empty())
    for (std::size_t i = 0; i < n; ++i)
      analysis.stations[i].reflection_coefficient =
          reflection(record.times, separate_waves(record.pressure[i], record.flow_rate[i],
                                                  record.characteristic_impedance[i]));

  for (double ByArrival::*definition :
       {&ByArrival::peak, &ByArrival::half, &ByArrival::tangent_foot, &ByArrival::phase})
  {
    std::vector<double> arrivals;
    for (const StationWave &station : analysis.stations)
      arrivals.push_back(station.arrival.*definition);
    analysis.speed.*definition = slope(arrivals, record.positions);
  }
  std::vector<double> logarithms;
  for (const StationWave &station : analysis.stations)
    logarithms.push_back(std::log(station.amplitude));
  analysis.attenuation = -slope(record.positions, logarithms);
  return analysis;
}
} // namespace Continua
