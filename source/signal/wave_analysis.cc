#include <continua/base/undefined.h>
#include <continua/signal/first_pulse.h>
#include <continua/signal/fourier_transform.h>
#include <continua/signal/two_wave_fit.h>
#include <continua/signal/wave_analysis.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
constexpr ByArrival nothing = {undefined, undefined, undefined, undefined};
/// From one station to the next a pulse grows and widens by less than these factors.
constexpr double largest_growth = 1.25;
constexpr double largest_widening = 1.3;
/// A pulse that is lower than this part of that at the station before has not come.
constexpr double least_of_previous = 0.25;
/// A backward wave that is larger than this part of the forward one overlaps with it.
constexpr double largest_backward = 0.1;
/// Rows of the record between the arrivals at the first and at the last station.
constexpr unsigned int least_rows = 3;
/// The other arrivals take up to this many times as long as the foot, or this much less.
constexpr double largest_change_of_shape = 1.5;
/// A record that begins with a slope of this part of the pulse's mean one begins within the rise.
constexpr double largest_first_slope = 0.25;
/// What heights may be off the line: absolutely, and of what the line falls.
constexpr double least_scatter = 1e-3, largest_scatter = 0.2;
/// What a fit of two waves may leave of the record, and how uncertain its attenuation may be. The
/// record is so many times as long as the pulse needs to the last station.
constexpr double largest_misfit_of_waves = 0.01, largest_uncertainty_of_waves = 0.1,
                 least_length_of_record = 1.5;
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

/// Whether the last value is the largest one, above the pulse if there is one.
bool still_rises(const std::vector<double> &pressure, const FirstPulse &pulse)
{
  const double last = pressure.back() - pressure.front();
  return last > 0. && std::max_element(pressure.begin(), pressure.end()) + 1 == pressure.end() &&
         !(last <= pulse.amplitude);
}

/// Whether a backward wave is there when the pressure of the station is largest.
bool meets_backward_wave(const WaveRecord &record,
                         const std::size_t station,
                         const double peak_time)
{
  if (record.flow_rate.empty())
    return false;
  const SeparatedWaves waves = separate_waves(record.pressure[station], record.flow_rate[station],
                                              record.characteristic_impedance[station]);
  const std::size_t peak = std::min<std::size_t>(
      std::lower_bound(record.times.begin(), record.times.end(), peak_time) - record.times.begin(),
      record.times.size() - 1);
  return std::abs(waves.backward[peak] - waves.backward.front()) >
         largest_backward * std::abs(waves.forward[peak] - waves.forward.front());
}

/// Whether the foot lies before a record that does not begin at rest.
bool lacks_foot(const WaveRecord &record, const std::size_t station, const FirstPulse &pulse)
{
  const std::vector<double> &pressure = record.pressure[station];
  const double first_slope = (pressure[1] - pressure[0]) / (record.times[1] - record.times[0]);
  const double mean_slope = 0.5 * (pulse.amplitude - pulse.level) / pulse.rise_time();
  return !record.begins_at_rest && first_slope > largest_first_slope * mean_slope;
}

/// Of few digits, which are the same on any machine.
std::string rounded(const double value)
{
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

/// The speed by one definition; NaN, and why, if the arrivals have none.
double speed_of(const WaveRecord &record,
                const std::vector<double> &arrivals,
                const std::vector<double> &feet,
                std::string &reason)
{
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < arrivals.size(); ++i)
    if (std::isfinite(arrivals[i]))
      used.push_back(i);
  if (used.size() < 2)
  {
    reason = arrivals.size() < 2 ? "a speed needs two stations" : too_few_stations;
    return undefined;
  }
  for (std::size_t i = 1; i < used.size(); ++i)
    if (!(arrivals[used[i]] > arrivals[used[i - 1]]))
    {
      const auto place_and_time = [&](const std::size_t station)
      {
        return rounded(std::abs(record.positions[station])) + " m (" + rounded(arrivals[station]) +
               " s)";
      };
      reason = "it comes to " + place_and_time(used[i]) + " no later than to " +
               place_and_time(used[i - 1]) + ", which is nearer to where it comes from";
      return undefined;
    }
  const double first = arrivals[used.front()], last = arrivals[used.back()];
  const auto rows = std::lower_bound(record.times.begin(), record.times.end(), last) -
                    std::lower_bound(record.times.begin(), record.times.end(), first);
  if (rows < least_rows)
  {
    reason = "the pulse passes all stations within " + rounded(last - first) + " s, in which are " +
             std::to_string(rows) + " rows: record more often, or set the stations farther apart";
    return undefined;
  }
  const double of_foot = feet[used.back()] - feet[used.front()];
  const double change = (last - first) / of_foot;
  if (of_foot > 0. && (change > largest_change_of_shape || change < 1. / largest_change_of_shape))
  {
    reason = "the pulse changes its shape, as overlapping pulses do: the foot takes " +
             rounded(of_foot) + " s from the first to the last station, this takes " +
             rounded(last - first) + " s";
    return undefined;
  }
  return slope(arrivals, record.positions);
}

/// The loss of the wave; NaN, and why, if the stations do not tell it.
double attenuation_of(const WaveRecord &record,
                      const std::vector<double> &heights,
                      const double speed,
                      const double last_arrival,
                      std::string &reason)
{
  std::vector<std::size_t> used;
  std::vector<double> places, logarithms;
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (std::isfinite(heights[i]))
    {
      used.push_back(i);
      places.push_back(record.positions[i]);
      logarithms.push_back(std::log(heights[i]));
    }
  if (places.size() < 3)
  {
    reason = "it needs three stations with a whole pulse, to tell the loss from other waves";
    return undefined;
  }
  const double rise = slope(places, logarithms);
  double mean_place = 0., mean_logarithm = 0., square = 0.;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    mean_place += places[i] / places.size();
    mean_logarithm += logarithms[i] / places.size();
  }
  for (std::size_t i = 0; i < places.size(); ++i)
    square += std::pow(logarithms[i] - mean_logarithm - rise * (places[i] - mean_place), 2) /
              places.size();
  const double scatter = std::sqrt(square), loss = -rise * (places.back() - places.front());
  if (scatter <= std::max(least_scatter, largest_scatter * std::abs(loss)))
    return -rise;

  reason = "another wave changes the heights: they lie off a straight line by " +
           rounded(100. * scatter) + " %, and the line falls by " + rounded(100. * loss) +
           " % from the first to the last station";
  if (record.flow_rate.empty() || !record.begins_at_rest || !std::isfinite(speed) ||
      record.times.back() - record.times.front() <
          least_length_of_record * (last_arrival - record.times.front()))
  {
    reason += "; to tell the waves apart takes flow rates from rest on, a wave speed, and a record "
              "half as long again as the pulse needs to the last station";
    return undefined;
  }
  const TwoWaveFit fit = fit_two_waves(record, used, speed);
  if (fit.misfit <= largest_misfit_of_waves && fit.uncertainty <= largest_uncertainty_of_waves &&
      fit.attenuation > 0.)
  {
    reason.clear();
    return fit.attenuation;
  }
  reason += "; two waves along a uniform tube do not explain the record (misfit " +
            rounded(100. * fit.misfit) + " %, attenuation " + rounded(fit.attenuation) +
            " 1/m, uncertain by " + rounded(100. * fit.uncertainty) + " %)";
  return undefined;
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
                        nothing,
                        undefined,
                        {}};
  std::vector<FirstPulse> pulses(n);
  const FirstPulse *previous = nullptr;
  bool overlaps = false;
  for (std::size_t i = 0; i < n; ++i)
  {
    FirstPulse &pulse = pulses[i] = find_first_pulse(record.times, record.pressure[i]);
    const bool is_there = std::isfinite(pulse.peak_time);
    if (is_there && lacks_foot(record, i, pulse))
      pulse.tangent_foot_time = undefined;
    MissingPulse &missing = analysis.stations[i].missing;
    if (previous != nullptr && is_there)
      overlaps = overlaps || pulse.amplitude > largest_growth * previous->amplitude ||
                 pulse.rise_time() > largest_widening * previous->rise_time();
    if (overlaps)
      missing = MissingPulse::overlaps;
    else if (still_rises(record.pressure[i], pulse))
      missing = MissingPulse::rises;
    else if (!is_there)
      missing = MissingPulse::no_peak;
    else if (previous != nullptr && pulse.amplitude < least_of_previous * previous->amplitude)
      missing = MissingPulse::not_come;
    else if (meets_backward_wave(record, i, pulse.peak_time))
    {
      missing = MissingPulse::overlaps;
      analysis.stations[i].arrival.tangent_foot = pulse.tangent_foot_time;
    }
    if (missing != MissingPulse::none)
    {
      pulse = find_first_pulse({}, {});
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

  const auto arrivals = [&](double ByArrival::*definition)
  {
    std::vector<double> result;
    for (const StationWave &station : analysis.stations)
      result.push_back(station.arrival.*definition);
    return result;
  };
  const std::vector<double> feet = arrivals(&ByArrival::tangent_foot);
  for (const auto &[definition, reason] :
       {std::make_pair(&ByArrival::peak, &MissingOfWave::peak),
        std::make_pair(&ByArrival::half, &MissingOfWave::half),
        std::make_pair(&ByArrival::tangent_foot, &MissingOfWave::tangent_foot),
        std::make_pair(&ByArrival::phase, &MissingOfWave::phase)})
    analysis.speed.*definition =
        speed_of(record, arrivals(definition), feet, analysis.missing.*reason);
  if (analysis.missing.phase == too_few_stations && analysis.missing.peak.empty())
    analysis.missing.phase = "the record ends within the window of the pulse, or the pressure does "
                             "not fall to 15 % of the pulse before it rises again";
  std::vector<double> heights;
  for (const StationWave &station : analysis.stations)
    heights.push_back(station.amplitude);
  analysis.attenuation = attenuation_of(record, heights, analysis.speed.peak,
                                        previous == nullptr ? undefined : previous->peak_time,
                                        analysis.missing.attenuation);
  return analysis;
}
} // namespace Continua
