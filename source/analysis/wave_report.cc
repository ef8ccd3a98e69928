#include <continua/analysis/wave_report.h>

#include <continua/base/six_digits.h>
#include <continua/base/table_writer.h>
#include <continua/base/undefined.h>
#include <continua/base/unit_scale.h>
#include <continua/signal/first_pulse.h>
#include <continua/signal/wave_analysis.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Continua
{
namespace
{
/// A backward wave counts as a pulse from this part of the first pulse's height on.
constexpr double smallest_reflection = 0.1;
const char *const speeds_and_attenuation[5] = {"wave speed", "wave speed at half height",
                                               "wave speed of the foot", "wave speed by phase",
                                               "attenuation"};
const char *const all_speeds =
    "wave speed, wave speed at half height, wave speed of the foot, wave speed by phase";

const std::vector<std::pair<MissingPulse, std::string>> &reasons_of_missing_pulse()
{
  static const std::vector<std::pair<MissingPulse, std::string>> reasons = {
      {MissingPulse::overlaps, "the pulse overlaps with a reflection"},
      {MissingPulse::rises, "the pressure still rises when the record ends"},
      {MissingPulse::not_come, "the record ends before the pulse has come"},
      {MissingPulse::no_peak, "the pressure does not rise and fall again in this time"}};
  return reasons;
}

std::string reason_of(const MissingPulse missing)
{
  for (const auto &[reason, text] : reasons_of_missing_pulse())
    if (reason == missing)
      return text;
  return "";
}

bool all_finite(const std::vector<double> &values)
{
  return std::all_of(values.begin(), values.end(),
                     [](const double value) { return std::isfinite(value); });
}

/// Whether a theory has values of this field and station, but not until the last time.
bool has_ended(const WaveSource &source, const std::vector<double> &values)
{
  return !source.is_measured && !all_finite(values) &&
         std::any_of(values.begin(), values.end(),
                     [](const double value) { return std::isfinite(value); });
}
} // namespace

WaveReport::WaveReport(const WaveStations &stations, const std::vector<double> &times)
    : stations(stations), times(times), n_analysed(times.size())
{
}

void WaveReport::set_end_of_first_beat(const double end_time)
{
  n_analysed = std::upper_bound(times.begin(), times.end(), end_time) - times.begin();
}

void WaveReport::set_beat(const double begin_time, const double end_time)
{
  const double slack = 1e-9 * end_time;
  first_analysed = std::lower_bound(times.begin(), times.end(), begin_time - slack) - times.begin();
  n_analysed = std::upper_bound(times.begin(), times.end(), end_time + slack) - times.begin() -
               first_analysed;
}

void WaveReport::add(const WaveSource &source, const Histories &histories)
{
  sources.push_back({source, histories, {}});
}

int WaveReport::field(const std::string &name) const
{
  const auto place = std::find(stations.fields.begin(), stations.fields.end(), name);
  return place == stations.fields.end() ? -1 : static_cast<int>(place - stations.fields.begin());
}

std::string WaveReport::station_name(const unsigned int station) const
{
  return stations.name + " " + named_value(stations.positions[station], "m");
}

void WaveReport::write(const std::string &file) const
{
  std::vector<std::string> header = {"time [s]"};
  std::vector<std::vector<double>> columns;
  const auto add = [&](const unsigned int station, const std::string &field,
                       const std::string &what, const std::string &unit,
                       const std::vector<double> &values)
  {
    header.push_back(station_name(station) + ": " + field + ", " + what + " [" + unit + "]");
    columns.push_back(values);
  };
  const int pressure = field("pressure");
  // Without an impedance the waves cannot be told apart.
  const int flow_rate = stations.impedances.empty() ? -1 : field("flow rate");
  for (unsigned int s = 0; s < stations.positions.size(); ++s)
  {
    for (unsigned int f = 0; f < stations.fields.size(); ++f)
    {
      for (const Data &data : sources)
        add(s, stations.fields[f], data.source.name, stations.units[f], data.histories[s][f]);
      for (std::size_t other = 1; other < sources.size(); ++other)
      {
        std::vector<double> difference = sources.front().histories[s][f];
        for (std::size_t i = 0; i < times.size(); ++i)
          difference[i] -= sources[other].histories[s][f][i];
        add(s, stations.fields[f], sources.front().source.name + " - " + sources[other].source.name,
            stations.units[f], difference);
      }
    }
    if (pressure >= 0 && flow_rate >= 0)
      for (const Data &data : sources)
        if (!data.source.is_measured)
        {
          const SeparatedWaves waves = separate_waves(
              data.histories[s][pressure], data.histories[s][flow_rate], stations.impedances[s]);
          add(s, "forward wave", data.source.name, "Pa", waves.forward);
          add(s, "backward wave", data.source.name, "Pa", waves.backward);
        }
  }
  TableWriter table(file, header);
  std::vector<double> row;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    row.assign(1, times[i]);
    for (const std::vector<double> &column : columns)
      row.push_back(column[i]);
    table.row(row);
  }
  table.flush();
}

std::string WaveReport::places_without_pulse(const std::vector<unsigned int> &used,
                                             const WaveAnalysis &wave) const
{
  std::string reasons;
  for (const auto &[reason, text] : reasons_of_missing_pulse())
  {
    std::string places;
    for (std::size_t i = 0; i < used.size(); ++i)
      if (wave.stations[i].missing == reason)
        places += (places.empty() ? "" : ", ") + named_value(stations.positions[used[i]], "m");
    if (!places.empty())
      reasons.append(reasons.empty() ? "" : "; ").append(text).append(" at ").append(places);
  }
  return reasons;
}

std::string WaveReport::records_in_part(const Histories &histories) const
{
  const int pressure = field("pressure");
  std::string text;
  for (unsigned int s = 0; s < stations.positions.size(); ++s)
  {
    const std::vector<double> &history = histories[s][pressure];
    const auto is_finite = [](const double value) { return std::isfinite(value); };
    const auto first = std::find_if(history.begin(), history.end(), is_finite);
    if (first == history.end() || all_finite(history))
      continue;
    const auto behind = std::find_if(history.rbegin(), history.rend(), is_finite).base();
    text += (text.empty() ? "" : ", ") + named_value(stations.positions[s], "m") + ": " +
            six_digits(times[first - history.begin()]) + " s to " +
            six_digits(times[behind - history.begin() - 1]) + " s";
  }
  return text;
}

std::vector<WaveReport::Pulse>
WaveReport::analyse(const Data &data, Summary &summary, Notes &notes) const
{
  const Histories &histories = data.histories;
  const bool is_measured = data.source.is_measured;
  const int pressure = field("pressure");
  // Without an impedance the waves cannot be told apart.
  const int flow_rate = stations.impedances.empty() ? -1 : field("flow rate");
  // Only stations that have the whole record; a measurement need not have all.
  WaveRecord record;
  record.times.assign(times.begin() + first_analysed, times.begin() + first_analysed + n_analysed);
  const auto analysed = [this](const std::vector<double> &history, const double sign)
  {
    const auto begin = history.begin() + first_analysed;
    std::vector<double> result(begin, begin + n_analysed);
    // From the start of the run on a history begins at rest.
    const double before = first_analysed > 0 ? result.front() : 0.;
    for (double &value : result)
      value = sign * (value - before);
    return result;
  };
  std::vector<unsigned int> order; // in which the pulse passes
  for (unsigned int s = 0; s < stations.positions.size(); ++s)
    order.push_back(s);
  if (stations.direction < 0.)
    std::reverse(order.begin(), order.end());
  std::vector<unsigned int> used;
  for (const unsigned int s : order)
    if (all_finite(histories[s][pressure]) &&
        (flow_rate < 0 || is_measured || all_finite(histories[s][flow_rate])))
    {
      used.push_back(s);
      record.positions.push_back(stations.direction * stations.positions[s]);
      record.pressure.push_back(analysed(histories[s][pressure], 1.));
      if (flow_rate >= 0 && !is_measured)
      {
        record.flow_rate.push_back(analysed(histories[s][flow_rate], stations.direction));
        record.characteristic_impedance.push_back(stations.impedances[s]);
      }
    }
  std::vector<Pulse> pulses(stations.positions.size(), {undefined, undefined, undefined, undefined,
                                                        undefined, undefined, undefined});
  const std::string &prefix = data.source.prefix;
  const std::string in_part = records_in_part(histories);
  if (used.empty() || n_analysed < 2)
  {
    const std::string reason =
        in_part.empty() || !used.empty()
            ? "no station has a whole record"
            : "no record of a pressure goes from the first to the last time of the run (" +
                  in_part + ")";
    for (const char *const name : speeds_and_attenuation)
      summary.add_absence(prefix + name, stations.name, reason);
    if (!in_part.empty())
      notes.lines.push_back(
          "No " + prefix + "wave speed and attenuation at the stations '" + stations.name +
          "': " + reason +
          (is_measured ? ". Give it a row at the first and at the last time of the run, or end the "
                         "run with it (Time/End time)"
                       : ""));
    return pulses;
  }
  if (!in_part.empty())
    notes.lines.push_back(
        "Left out of the " + prefix + "speeds and the attenuation at the stations '" +
        stations.name +
        "', since they do not go from the first to the last time of the run: " + in_part);
  record.begins_at_rest = first_analysed == 0;
  const WaveAnalysis wave = analyse_wave(record);
  const auto add = [&](const std::string &name, const double value, const std::string &unit,
                       const std::string &probe, const std::string &why_absent)
  {
    if (std::isfinite(value))
      summary.add({prefix + name, value, unit, probe});
    else
      summary.add_absence(prefix + name, probe, why_absent);
  };
  const std::string without_pulse = places_without_pulse(used, wave);
  // What is absent for one reason stands in one line.
  std::vector<std::pair<std::string, std::string>> absent; // reason, names
  const auto add_of_all = [&](const std::string &name, const double value, const std::string &unit,
                              const std::string &why_absent)
  {
    const std::string reason = without_pulse.empty() || why_absent.empty() ? why_absent
                               : why_absent == too_few_stations            ? without_pulse
                                                                : why_absent + "; " + without_pulse;
    add(name, value, unit, stations.name, reason);
    if (std::isfinite(value))
      return;
    if (absent.empty() || absent.back().first != reason)
      absent.emplace_back(reason, name);
    else
      absent.back().second += ", " + name;
  };
  add_of_all("wave speed", wave.speed.peak, "m/s", wave.missing.peak);
  add_of_all("wave speed at half height", wave.speed.half, "m/s", wave.missing.half);
  add_of_all("wave speed of the foot", wave.speed.tangent_foot, "m/s", wave.missing.tangent_foot);
  add_of_all("wave speed by phase", wave.speed.phase, "m/s", wave.missing.phase);
  add_of_all("attenuation", wave.attenuation, "1/m", wave.missing.attenuation);
  // Where there is no speed, a line on the loss of the wave says nothing new.
  if (absent.size() > 1 && absent.front().second == all_speeds)
    absent.resize(1);
  for (const auto &[reason, names] : absent)
  {
    std::string line = "No " + prefix;
    line.append(names == all_speeds ? "wave speed" : names).append(" at the stations '");
    notes.lines.push_back(line.append(stations.name).append("': ").append(reason));
  }
  if (absent.empty() && !without_pulse.empty())
    notes.details.push_back("Left out of the " + prefix +
                            "speeds and the attenuation at the stations '" + stations.name +
                            "': " + without_pulse);
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    const StationWave &station = wave.stations[i];
    Pulse &pulse = pulses[used[i]];
    pulse = {station.arrival.peak,
             station.amplitude,
             station.arrival.half,
             station.arrival.tangent_foot,
             undefined,
             undefined,
             undefined};
    const std::string name = station_name(used[i]), why = reason_of(station.missing);
    add("first pulse time", pulse.time, "s", name, why);
    add("first pulse height", pulse.height, "Pa", name, why);
    add("half height time", pulse.half_time, "s", name, why);
    add("foot time", pulse.foot_time, "s", name,
        why.empty() ? "the record begins within the rise" : why);
    if (record.flow_rate.empty())
      continue;
    pulse.reflection = station.reflection_coefficient;
    const std::vector<double> backward =
        separate_waves(record.pressure[i], record.flow_rate[i], stations.impedances[used[i]])
            .backward;
    const std::size_t highest =
        std::max_element(backward.begin(), backward.end()) - backward.begin();
    // What is less is not a pulse but the impedance, which is that of a long wave; at the record's
    // end it still rises.
    if (highest > 0 && highest + 1 < backward.size() &&
        backward[highest] > smallest_reflection * pulse.height)
    {
      const Vertex vertex = refine_extremum(record.times, backward, highest);
      pulse.reflected_time = vertex.time;
      pulse.reflected_height = vertex.value;
    }
    add("reflection coefficient", pulse.reflection, "1", name,
        "the backward wave has no largest value within the record, or is below a millionth of the "
        "forward wave");
    const char *const no_reflected_pulse = "the backward wave has no largest value within the "
                                           "record, or is below a tenth of the first "
                                           "pulse";
    add("reflected pulse time", pulse.reflected_time, "s", name, no_reflected_pulse);
    add("reflected pulse height", pulse.reflected_height, "Pa", name, no_reflected_pulse);
  }
  return pulses;
}

void WaveReport::compare(const Data &a, const Data &b, Summary &summary) const
{
  const Histories &first = a.histories, &second = b.histories;
  const std::string &suffix = b.source.from;
  for (unsigned int f = 0; f < stations.fields.size(); ++f)
  {
    double largest = 0., difference = 0.;
    std::string ended;
    for (unsigned int s = 0; s < stations.positions.size(); ++s)
    {
      // What is left of it says nothing of the time behind its end.
      for (const auto &[data, values] : {std::pair(&a, &first[s][f]), std::pair(&b, &second[s][f])})
        if (has_ended(data->source, *values))
          ended = data->source.name;
      for (std::size_t i = 0; i < times.size(); ++i)
        if (std::isfinite(second[s][f][i]) && std::isfinite(first[s][f][i]))
        {
          largest = std::max(largest, std::abs(second[s][f][i]));
          difference = std::max(difference, std::abs(first[s][f][i] - second[s][f][i]));
        }
    }
    if (!ended.empty())
      summary.add_absence("largest difference of " + stations.fields[f] + suffix, stations.name,
                          "the values of '" + ended + "' end before the run does");
    else if (largest > 0.)
      summary.add({"largest difference of " + stations.fields[f] + suffix, difference / largest,
                   "1", stations.name});
  }
  if (a.pulses.empty() || b.pulses.empty())
    return;
  const auto largest_of = [&](const std::string &name, double Pulse::*what)
  {
    double largest = undefined;
    unsigned int n_compared = 0;
    for (unsigned int s = 0; s < stations.positions.size(); ++s)
    {
      const double relative = std::abs(a.pulses[s].*what / (b.pulses[s].*what) - 1.);
      if (!std::isfinite(relative))
        continue;
      ++n_compared;
      if (!(relative <= largest))
        largest = relative;
    }
    if (n_compared == 0)
    {
      summary.add_absence("largest difference of " + name + suffix, stations.name,
                          "no station has it in both");
      return;
    }
    summary.add({"largest difference of " + name + suffix, largest, "1", stations.name});
    summary.add({"stations compared by " + name + suffix, static_cast<double>(n_compared), "1",
                 stations.name});
  };
  largest_of("first pulse time", &Pulse::time);
  largest_of("first pulse height", &Pulse::height);
  largest_of("reflected pulse time", &Pulse::reflected_time);
  largest_of("reflected pulse height", &Pulse::reflected_height);
}

void WaveReport::name_quantities(const WaveStations &stations,
                                 const std::vector<WaveSource> &sources,
                                 QuantityNames &names)
{
  const auto has_field = [&](const char *const name)
  {
    return std::find(stations.fields.begin(), stations.fields.end(), name) != stations.fields.end();
  };
  const bool pressure = has_field("pressure"),
             flow_rate = has_field("flow rate") && !stations.impedances.empty();
  const auto station_label = [&](const double position)
  { return stations.name + " " + named_value(position, "m"); };
  for (const WaveSource &source : sources)
  {
    const std::string &prefix = source.prefix;
    if (!pressure)
      continue;
    for (const char *const name : speeds_and_attenuation)
      names.add(prefix + name, stations.name);
    for (const double position : stations.positions)
    {
      for (const char *const name :
           {"first pulse time", "first pulse height", "half height time", "foot time"})
        names.add(prefix + name, station_label(position));
      if (flow_rate && !source.is_measured)
        for (const char *const name :
             {"reflection coefficient", "reflected pulse time", "reflected pulse height"})
          names.add(prefix + name, station_label(position));
    }
  }
  for (std::size_t other = 1; other < sources.size(); ++other)
  {
    const std::string &suffix = sources[other].from;
    for (const std::string &field : stations.fields)
      names.add(std::string("largest difference of ").append(field).append(suffix), stations.name);
    if (pressure)
      for (const std::string name : {"first pulse time", "first pulse height",
                                     "reflected pulse time", "reflected pulse height"})
      {
        names.add(std::string("largest difference of ").append(name).append(suffix), stations.name);
        names.add(std::string("stations compared by ").append(name).append(suffix), stations.name);
      }
  }
}

WaveReport::Notes WaveReport::add_quantities(Summary &summary)
{
  Notes notes;
  if (field("pressure") >= 0)
    for (Data &data : sources)
      data.pulses = analyse(data, summary, notes);
  for (std::size_t other = 1; other < sources.size(); ++other)
    compare(sources.front(), sources[other], summary);
  return notes;
}
} // namespace Continua
