#include <continua/case/measured_waves.h>

#include <continua/base/csv_table.h>

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

MeasuredWaves::MeasuredWaves(const std::string &file,
                             const std::vector<double> &positions,
                             const std::vector<std::string> &fields)
    : n_stations(positions.size()), n_fields(fields.size())
{
  const CsvTable table(file, "time [ms], 0.1 m: pressure [mmHg]");
  table.require_rows(2);
  const std::vector<double> times = table.increasing_values(0, Dimensions::time, "time", "later");
  for (std::size_t c = 1; c < table.n_columns(); ++c)
  {
    const std::string &name = table.name(c);
    const auto refuse = [&](const std::string &problem)
    {
      std::string stations, field_names;
      for (const double position : positions)
        stations.append(stations.empty() ? "" : ", ")
            .append(shortest_number(position))
            .append(" m");
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
    std::size_t station = 0, field = 0;
    while (station < positions.size() && std::abs(positions[station] - position) > 1e-6)
      ++station;
    while (field < fields.size() && fields[field] != field_name)
      ++field;
    if (station == positions.size())
      refuse("the probe has no station there");
    if (field == fields.size())
      refuse("the probe does not record this field");
    for (const Column &column : columns)
      if (column.station == station && column.field == field)
        refuse("this field of the station is given twice");
    columns.push_back({station, field,
                       Interpolant(times, table.values(c, dimension_of_station_field(field_name)),
                                   Interpolant::Kind::linear)});
  }
}

std::string MeasuredWaves::read_file(ParameterSection probe)
{
  std::string file;
  probe.add_input_file(
      "Measured", file,
      "With Stations: a csv file of what was measured there, which stands beside "
      "simulation and theory in wave.csv. Its header is 'time [ms], 0.1 m: pressure "
      "[mmHg], ...' with stations and Fields of this probe (units required).");
  return file;
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
      if (times[i] >= column.values.first_point() && times[i] <= column.values.last_point())
        result[column.station][column.field][i] = column.values(times[i]);
  return result;
}
} // namespace Continua
