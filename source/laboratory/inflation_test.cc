#include <continua/laboratory/inflation_test.h>

#include <continua/base/csv_table.h>

namespace Continua
{
namespace
{
constexpr Dimension force_of_a_tube{1, 1, -2};

bool is_column(const CsvTable &table, const std::string &name)
{
  for (std::size_t column = 0; column < table.n_columns(); ++column)
    if (table.name(column) == name)
      return true;
  return false;
}
} // namespace

InflationTest read_inflation_test(const std::string &file)
{
  const std::string example =
      "axial stretch [1], pressure [kPa], outer diameter [mm], axial force [mN]";
  InflationTest test;
  test.file = file;
  const CsvTable table(file, example);
  test.is_outer = is_column(table, "outer diameter");
  if (test.is_outer == is_column(table, "inner diameter"))
    throw InputError(table.header(), "",
                     std::string(test.is_outer ? "both 'outer diameter' and 'inner diameter' are "
                                                 "columns"
                                               : "neither 'outer diameter' nor 'inner diameter' is "
                                                 "a column") +
                         "; the columns are " + table.names(),
                     "Give one of them, as in '" + example + "'");
  test.has_force = is_column(table, "axial force");
  const std::size_t stretch_column = table.find("axial stretch"),
                    pressure_column = table.find("pressure"),
                    diameter_column =
                        table.find(test.is_outer ? "outer diameter" : "inner diameter");
  const std::vector<double> stretches = table.values(stretch_column, Dimensions::none),
                            pressures = table.values(pressure_column, Dimensions::pressure),
                            diameters = table.values(diameter_column, Dimensions::length);
  std::vector<double> forces(table.n_rows(), 0.);
  if (test.has_force)
    forces = table.values(table.find("axial force"), force_of_a_tube);
  for (std::size_t row = 0; row < table.n_rows(); ++row)
  {
    if (!(stretches[row] >= 0.2 && stretches[row] <= 5.))
      table.refuse(row, stretch_column,
                   "an axial stretch is the length over that of the ring without load",
                   "Give values between 0.2 and 5; a strain e is the stretch 1 + e");
    if (pressures[row] < 0.)
      table.refuse(row, pressure_column, "the pressure is below that outside",
                   "Remove the row: a tube that collapses is not round");
    if (!(diameters[row] > 0.))
      table.refuse(row, diameter_column, "a diameter must be positive", "Remove the row");
    test.rows.push_back({stretches[row], pressures[row], diameters[row], forces[row]});
  }
  return test;
}

std::vector<DataRecord> InflationTest::data_records(const double diameter_noise,
                                                    const double force_noise) const
{
  DataRecord diameter, force;
  diameter.name = is_outer ? "outer diameter" : "inner diameter";
  diameter.unit = "m";
  diameter.noise.standard_deviation = diameter_noise;
  force.name = "axial force";
  force.unit = "N";
  force.noise.standard_deviation = force_noise;
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    diameter.times.push_back(row);
    diameter.values.push_back(rows[row].diameter);
    force.times.push_back(row);
    force.values.push_back(rows[row].axial_force);
  }
  std::vector<DataRecord> records = {diameter};
  if (has_force)
    records.push_back(force);
  return records;
}
} // namespace Continua
