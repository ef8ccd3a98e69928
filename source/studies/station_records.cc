#include <continua/studies/station_records.h>

#include <continua/base/nearest_name.h>
#include <continua/base/unit_scale.h>
#include <continua/inference/autoregressive_model.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace Continua
{
namespace
{
/// Of an interval, by which the times of rows may differ from equal ones: they may be rounded.
constexpr double interval_slack = 0.1;
/// Rows at rest from which correlation can be told.
constexpr std::size_t fewest_rows_at_rest = 20;

/// The interval [s] of times that follow each other equally; 0 if they do not.
double interval_of(const std::vector<double> &times)
{
  if (times.size() < 2)
    return 0.;
  const double interval = (times.back() - times.front()) / (times.size() - 1);
  for (std::size_t i = 0; i < times.size(); ++i)
    if (std::abs(times[i] - times.front() - i * interval) > interval_slack * interval)
      return 0.;
  return interval;
}

using Deviations = std::vector<std::pair<std::string, std::string>>;

/// What the section says of a record: an entry of its own, or that of its field; null if nothing.
const std::pair<std::string, std::string> *
find_deviation(const Deviations &deviations, const std::string &record, const std::string &field)
{
  for (const std::string &name : {record, field})
    for (const auto &deviation : deviations)
      if (with_value_in_si(deviation.first) == name || deviation.first == name)
        return &deviation;
  return nullptr;
}

/// Finds the correlation of a record's noise in the rows before a time [s]. `deviation`: its entry
/// in the section.
void set_noise_from_rest(const ParameterSection &section,
                         const std::string &deviation,
                         const double until,
                         const OrderCriterion criterion,
                         DataRecord &record,
                         std::vector<std::string> &notes)
{
  const auto refuse = [&](const std::string &problem)
  {
    section.refuse(deviation, "'" + record.name + "' " + problem,
                   "Give a number with a unit instead, or another table");
  };
  const std::size_t n =
      std::lower_bound(record.times.begin(), record.times.end(), until) - record.times.begin();
  if (record.interval == 0.)
    refuse("has rows that do not follow each other equally, so nothing tells their correlation");
  if (n < fewest_rows_at_rest)
    refuse("has " + std::to_string(n) + " rows before Rest until, and its noise needs " +
           std::to_string(fewest_rows_at_rest));
  const std::vector<double> rest(record.values.begin(), record.values.begin() + n);
  if (std::all_of(rest.begin(), rest.end(),
                  [&rest](const double value) { return value == rest.front(); }))
    refuse("has equal values at rest, which is no noise");
  const AutoregressiveModel found = fit_autoregressive_model_of_best_order(rest, criterion, true);
  record.noise.autoregressive = found.coefficients;
  std::ostringstream text;
  text.precision(3);
  text << "Noise of '" << record.name << "' at rest (" << n
       << " rows): " << found.standard_deviation << " " << record.unit << ", "
       << record.noise.description();
  notes.push_back(text.str());
}

/// Sets the noise of the record to a number.
void set_noise(const ParameterSection &section,
               const std::pair<std::string, std::string> &deviation,
               const double correlation_time,
               DataRecord &record,
               const RecordSource &source)
{
  try
  {
    record.noise.standard_deviation =
        parse_quantity(deviation.second, dimension_of_station_field(source.field_name));
  }
  catch (const std::invalid_argument &error)
  {
    section.refuse(deviation.first, error.what(),
                   "Give a number with a unit, such as " +
                       usual_units(dimension_of_station_field(source.field_name)) +
                       ", or 'from rest'");
  }
  if (!(record.noise.standard_deviation > 0.))
    section.refuse(deviation.first, "the noise is not positive", "Give a positive number");
  record.noise.correlation_time = correlation_time;
}

/// Throws InputError for an entry that no record has.
void check_names(const ParameterSection &section,
                 const Deviations &deviations,
                 const StationRecords &all)
{
  std::vector<std::string> names;
  for (std::size_t r = 0; r < all.records.size(); ++r)
  {
    names.push_back(all.sources[r].field_name);
    names.push_back(all.records[r].name);
  }
  for (const auto &deviation : deviations)
    if (std::none_of(names.begin(), names.end(),
                     [&](const std::string &name) {
                       return name == deviation.first || name == with_value_in_si(deviation.first);
                     }))
    {
      const std::string nearest = nearest_name(deviation.first, names);
      section.refuse(deviation.first, "no record and no field is called so",
                     nearest.empty() ? "Name a field, or a record 'PROBE STATION: FIELD'"
                                     : "Did you mean '" + nearest + "'?");
    }
}

/// A record of a field of a station, without times.
void add_record(const StationsProbe &probe,
                const unsigned int number,
                const unsigned int station,
                const unsigned int field,
                StationRecords &all)
{
  const std::string &name = probe.fields[field];
  DataRecord record;
  record.name = record_name(probe.name, probe.positions[station], name);
  record.unit = dimension_of_station_field(name).unit();
  all.records.push_back(record);
  all.sources.push_back({number, station, field, probe.positions[station], probe.name, name});
}

/// The bounds of the shift of a probe's clock [s]; both 0 if it is not sought.
std::pair<double, double> clock_bounds(const std::vector<SoughtEntry> &sought,
                                       const std::string &probe)
{
  for (const SoughtEntry &number : sought)
    if (number.clock_of() == probe)
      return {number.parameter.lower, number.parameter.upper};
  return {0., 0.};
}

/// The shift of a probe's clock in the file [s], if it is sought: the times that were read have it.
double clock_in_file(const std::vector<SoughtEntry> &sought, const std::string &probe)
{
  for (const SoughtEntry &number : sought)
    if (number.clock_of() == probe)
      return number.entry.value();
  return 0.;
}
} // namespace

std::string record_name(const std::string &probe, const double position, const std::string &field)
{
  return probe + " " + named_value(position, "m") + ": " + field;
}

std::size_t StationRecords::n_values() const
{
  return std::accumulate(records.begin(), records.end(), std::size_t(0),
                         [](const std::size_t sum, const DataRecord &record)
                         { return sum + record.size(); });
}

template <int dim>
StationRecords StationRecords::measured(const Case<dim> &input,
                                        const IdentificationParameters &parameters,
                                        const std::vector<SoughtEntry> &sought,
                                        ParameterSection section,
                                        const bool before_start)
{
  StationRecords all;
  const ParameterSection noise = section.subsection("Noise");
  const std::vector<StationsProbe> &probes = input.probes.stations();
  for (unsigned int p = 0; p < probes.size(); ++p)
  {
    const auto measured = input.measured_waves.find(probes[p].name);
    if (measured == input.measured_waves.end())
      continue;
    if (probes[p].section.given("Measured period"))
      probes[p].section.refuse("Measured period",
                               "an identification takes the rows of Measured as they stand",
                               "Remove the entry, and give the rows of all beats");
    const double in_file = clock_in_file(sought, probes[p].name);
    const auto [earliest, latest] = clock_bounds(sought, probes[p].name);
    for (const MeasuredWaves::Record &rows : measured->second.records())
    {
      add_record(probes[p], p, rows.station, rows.field, all);
      DataRecord &record = all.records.back();
      for (std::size_t i = 0; i < rows.times.size(); ++i)
      {
        const double time = rows.times[i] - in_file;
        if (time + latest <= input.time.end_time * (1. + 1e-12) && std::isfinite(rows.values[i]) &&
            (before_start || time + earliest >= 0.))
        {
          record.times.push_back(time);
          record.values.push_back(rows.values[i]);
        }
        else
          ++all.n_left_out;
      }
      if (record.times.empty())
        probes[p].section.refuse("Measured",
                                 "no row of '" + record.name + "' lies in the time of the run",
                                 "Check Measured shift and Time/End time");
      record.interval = interval_of(record.times);
      const auto *deviation =
          find_deviation(parameters.noise.deviations, record.name, all.sources.back().field_name);
      if (deviation != nullptr && deviation->second == "from rest")
        set_noise_from_rest(noise, deviation->first, parameters.rest_until - in_file,
                            parameters.order_criterion, record, all.notes);
      else if (deviation != nullptr)
        set_noise(noise, *deviation, parameters.correlation_time, record, all.sources.back());
      if (record.interval == 0.)
        all.notes.push_back("The rows of '" + record.name +
                            "' do not follow each other equally: their noise counts as white, and "
                            "nothing checks that");
      if (record.interval == 0. && record.noise.correlation_time > 0.)
        section.refuse("Correlation time",
                       "the rows of '" + record.name + "' do not follow each other equally",
                       "Remove the entry, or give rows at equal intervals");
    }
  }
  check_names(noise, parameters.noise.deviations, all);
  return all;
}

template <int dim>
StationRecords StationRecords::expected(const Case<dim> &input,
                                        const IdentificationParameters &parameters,
                                        ParameterSection section)
{
  StationRecords all;
  const ParameterSection noise = section.subsection("Expected noise");
  const double interval =
      parameters.sampling_interval > 0. ? parameters.sampling_interval : input.time.time_step;
  std::vector<double> times;
  for (unsigned int i = 0; i * interval <= input.time.end_time * (1. + 1e-12); ++i)
    times.push_back(std::min(i * interval, input.time.end_time));
  if (times.size() < 2)
    section.refuse("Sampling interval", "it is longer than the run", "Give a shorter one");
  const std::vector<StationsProbe> &probes = input.probes.stations();
  for (unsigned int p = 0; p < probes.size(); ++p)
    for (unsigned int s = 0; s < probes[p].positions.size(); ++s)
      for (unsigned int f = 0; f < probes[p].fields.size(); ++f)
      {
        const std::string name =
            record_name(probes[p].name, probes[p].positions[s], probes[p].fields[f]);
        const auto *deviation =
            find_deviation(parameters.expected_noise.deviations, name, probes[p].fields[f]);
        // What has no noise is not measured.
        if (deviation == nullptr)
          continue;
        if (deviation->second == "from rest")
          noise.refuse(deviation->first, "there are no data at rest", "Give a number with a unit");
        add_record(probes[p], p, s, f, all);
        all.records.back().times = times;
        all.records.back().interval = interval;
        set_noise(noise, *deviation, parameters.correlation_time, all.records.back(),
                  all.sources.back());
      }
  check_names(noise, parameters.expected_noise.deviations, all);
  return all;
}

template StationRecords StationRecords::measured(const Case<2> &,
                                                 const IdentificationParameters &,
                                                 const std::vector<SoughtEntry> &,
                                                 ParameterSection,
                                                 bool);
template StationRecords StationRecords::measured(const Case<3> &,
                                                 const IdentificationParameters &,
                                                 const std::vector<SoughtEntry> &,
                                                 ParameterSection,
                                                 bool);
template StationRecords
StationRecords::expected(const Case<2> &, const IdentificationParameters &, ParameterSection);
template StationRecords
StationRecords::expected(const Case<3> &, const IdentificationParameters &, ParameterSection);
} // namespace Continua
