#include <continua/case/measured_waves.h>

#include <continua/base/csv_table.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace Continua
{
const Dimension &dimension_of_station_field(const std::string &field)
{
  static const std::map<std::string, Dimension> dimensions = {
      {"pressure", Dimensions::pressure},          {"axis pressure", Dimensions::pressure},
      {"flow rate", Dimensions::flow_rate},        {"velocity integral", Dimensions::flow_rate},
      {"wall distension", Dimensions::length},     {"pressure gradient", Dimensions::force_density},
      {"wall shear stress", Dimensions::pressure}, {"hoop stress", Dimensions::pressure}};
  return dimensions.at(field);
}

namespace
{
/// Of the largest position, by which two numbers for one station may differ.
constexpr double position_slack = 1e-9;

/// The station at a position [m]; the number of stations if there is none.
std::size_t station_at(const std::vector<double> &stations, const double position)
{
  double largest = std::abs(position);
  for (const double station : stations)
    largest = std::max(largest, std::abs(station));
  std::size_t nearest = stations.size();
  for (std::size_t s = 0; s < stations.size(); ++s)
    if (const double distance = std::abs(stations[s] - position);
        distance <= position_slack * largest &&
        (nearest == stations.size() || distance < std::abs(stations[nearest] - position)))
      nearest = s;
  return nearest;
}
} // namespace

void MeasuredWavesEntries::read(ParameterSection probe)
{
  probe.add_input_file(
      "Measured", file,
      "With Stations: a csv file of what was measured there, which stands beside "
      "simulation and theory in wave.csv. Its header is 'time [ms], 0.1 m: pressure "
      "[mmHg], ...' with stations and Fields of this probe (units required).");
  probe.add("Measured factors", factors, Dimensions::none,
            "What the columns of Measured behind the time are multiplied by, such as -1 for a flow "
            "that was counted in the other direction: one number for all, or one for each column; "
            "empty: 1.");
  probe.add("Measured shift", shift, Dimensions::time,
            "Added to the times of Measured: by how much later it was measured in the time of the "
            "run.");
  probe.add("Measured period", period, Dimensions::time,
            "The period with which Measured repeats itself, such as that of a heart beat. Between "
            "the last row and the first one of the next period its values are interpolated. 0: it "
            "is not repeated.",
            Range::not_negative());
  for (const char *const key : {"Measured factors", "Measured shift", "Measured period"})
    if (file.empty() && probe.given(key))
      probe.refuse(key, "the entry belongs to Measured",
                   "Add 'set Measured = FILE', or remove the entry");
}

MeasuredWaves::MeasuredWaves(const MeasuredWavesEntries &entries,
                             const ParameterSection &probe,
                             const std::vector<double> &positions,
                             const std::vector<std::string> &fields)
    : n_stations(positions.size()), n_fields(fields.size())
{
  const CsvTable table(entries.file, "time [ms], 0.1 m: pressure [mmHg]",
                       scaling_advice("Measured factors"));
  const std::size_t n_factors = entries.factors.size();
  if (n_factors > 1 && n_factors + 1 != table.n_columns())
    probe.refuse("Measured factors",
                 "there are " + std::to_string(n_factors) + " factors, but " +
                     std::to_string(table.n_columns() - 1) + " columns behind the time",
                 "Give one number for all columns, or one for each");
  for (std::size_t c = 1; c < table.n_columns(); ++c)
  {
    const std::string &name = table.name(c);
    const auto refuse = [&](const std::string &problem)
    {
      std::string stations, field_names;
      for (const double position : positions)
        stations.append(stations.empty() ? "" : ", ").append(named_value(position, "m"));
      for (const std::string &field : fields)
        field_names += (field_names.empty() ? "" : ", ") + field;
      throw InputError(table.header(), name, problem,
                       "Call it 'STATION: FIELD' with a station of the probe (" + stations +
                           ") and one of its fields (" + field_names + ")");
    };
    const std::size_t colon = name.find(':');
    if (colon == std::string::npos)
      refuse("the column's name has no station");
    double position = 0.;
    try
    {
      position = parse_quantity(name.substr(0, colon), Dimensions::length);
    }
    catch (const std::invalid_argument &error)
    {
      refuse(std::string("the column's name has no station: ") + error.what());
    }
    std::string field_name = name.substr(colon + 1);
    field_name.erase(0, field_name.find_first_not_of(' '));
    const std::size_t station = station_at(positions, position);
    std::size_t field = 0;
    while (field < fields.size() && fields[field] != field_name)
      ++field;
    if (station == positions.size())
      refuse("the probe has no station there");
    if (field == fields.size())
      refuse("the probe does not record this field");
    for (const Column &column : columns)
      if (column.station == station && column.field == field)
        refuse("this field of the station is given twice");
    TimeTable::Reading reading;
    reading.before = reading.after =
        entries.period > 0. ? TimeTable::Outside::repeat : TimeTable::Outside::nothing;
    reading.factor = n_factors == 0 ? 1. : entries.factors[n_factors == 1 ? 0 : c - 1];
    reading.shift = entries.shift;
    reading.period = entries.period;
    reading.period_key = "Measured period";
    const Dimension &dimension = dimension_of_station_field(field_name);
    columns.push_back({station, field, TimeTable(table, c, dimension, reading)});
    Record record{station, field, table.increasing_values(0, Dimensions::time, "time", "later"),
                  table.values(c, dimension)};
    for (double &time : record.times)
      time += reading.shift;
    for (double &value : record.values)
      value *= reading.factor;
    rows.push_back(std::move(record));
  }
}

std::vector<std::vector<std::vector<double>>>
MeasuredWaves::histories(const std::vector<double> &times) const
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::vector<std::vector<double>>> result(
      n_stations,
      std::vector<std::vector<double>>(n_fields, std::vector<double>(times.size(), nan)));
  for (const Column &column : columns)
    for (std::size_t i = 0; i < times.size(); ++i)
      result[column.station][column.field][i] = column.values(times[i]);
  return result;
}
} // namespace Continua
