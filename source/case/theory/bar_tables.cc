#include <continua/case/theory/bar_tables.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Continua
{
namespace
{
constexpr Dimension force_of_a_bar{1, 1, -2};
/// A table of fewer values tells no noise.
constexpr std::size_t fewest_bar_rows = 3;

bool has_bar_column(const CsvTable &table, const std::string &name)
{
  for (std::size_t column = 0; column < table.n_columns(); ++column)
    if (table.name(column) == name)
      return true;
  return false;
}
} // namespace

std::vector<double> times_of_bar_table(const CsvTable &table)
{
  const std::size_t column = table.find("time");
  std::vector<double> times = table.increasing_values(column, Dimensions::time, "time", "later");
  if (!times.empty() && times.front() < 0.)
    table.refuse(0, column, "the time is negative: the load begins at time 0",
                 "Let time 0 be the start of the load, and remove the rows before it");
  return times;
}

void require_positive_value(const CsvTable &table,
                            const std::size_t row,
                            const std::size_t column,
                            const double value,
                            const std::string &remedy)
{
  if (!remedy.empty() && !(value > 0.))
    table.refuse(row, column,
                 "the " + table.name(column) + " must be positive where the noise is relative",
                 remedy);
}

void check_bar_record(const CsvTable &table,
                      const BarRecord &record,
                      const std::size_t n_rows,
                      const ParameterSection &section,
                      const std::string &key)
{
  if (n_rows < fewest_bar_rows)
    throw InputError(
        table.header(), "",
        "the table has " + std::to_string(n_rows) + " rows that can be used, and a fit needs " +
            std::to_string(fewest_bar_rows) + "; rows up to the end of the loading are not used",
        "Give more rows");
  if (std::all_of(record.values.begin(), record.values.end(),
                  [](const double value) { return value == 0.; }))
    throw InputError(table.header(), "", "all values are 0", "Give the values that were measured");
  // Far beyond every material there is, and where powers of it can no longer be held.
  constexpr double largest_modulus = 1e15, smallest_modulus = 1e-9;
  for (const double value : record.values)
    if (const double modulus = std::abs(record.quantity == BarQuantity::creep ? 1. / value : value);
        value != 0. && !(modulus <= largest_modulus && modulus >= smallest_modulus))
      section.refuse(key,
                     "the table gives a modulus of " + shortest_number(modulus) +
                         " Pa, which no material has",
                     "Check this entry and the units of the table");
}

std::optional<BarRelaxation> BarRelaxation::read(ParameterSection &section,
                                                 const std::string &remedy)
{
  std::string file;
  section.add_input_file("Relaxation table", file,
                         "A csv file of a relaxation test with the columns time and force or "
                         "stress, units in its header. Time 0 is the start of the loading.");
  double cross_section = std::numeric_limits<double>::quiet_NaN(), strain = cross_section,
         loading_time = 0.;
  section.add("Cross-section", cross_section, Dimensions::area,
              "Cross-section of the specimen of the relaxation table. Required for forces.",
              Range::positive());
  section.add("Strain", strain, Dimensions::none,
              "Strain that is held in the relaxation table. Required for this table.",
              Range::positive());
  section.add("Loading time", loading_time, Dimensions::time,
              "Time in which the strain of the relaxation table rises evenly from 0, at time 0. "
              "The fit takes the loading into account; rows up to its end are left out.",
              Range::not_negative());
  if (file.empty())
  {
    for (const char *key : {"Cross-section", "Strain", "Loading time"})
      if (section.given(key))
        section.refuse(key, "there is no relaxation table to which this belongs",
                       "Add 'set Relaxation table = FILE', or remove it");
    return {};
  }
  section.require("Strain");
  const CsvTable table(file, "time [s], stress [kPa]");
  const std::vector<double> times = times_of_bar_table(table);
  const bool is_force = has_bar_column(table, "force");
  if (is_force == has_bar_column(table, "stress"))
    throw InputError(table.header(), "",
                     std::string(is_force ? "both 'force' and 'stress' are columns"
                                          : "neither 'force' nor 'stress' is a column") +
                         "; the columns are " + table.names(),
                     "Give one of them, as in 'time [s], stress [kPa]'");
  if (is_force)
    section.require("Cross-section");
  else if (section.given("Cross-section"))
    section.refuse("Cross-section", "the relaxation table has stresses, which need none",
                   "Remove it");
  const std::size_t column = table.find(is_force ? "force" : "stress");
  const std::vector<double> loads =
      table.values(column, is_force ? force_of_a_bar : Dimensions::pressure);
  BarRelaxation test;
  BarRecord &record = test.record;
  record.loading_time = loading_time;
  for (std::size_t row = 0; row < times.size(); ++row)
  {
    if (times[row] <= loading_time)
    {
      ++test.n_left_out;
      continue;
    }
    require_positive_value(table, row, column, loads[row], remedy);
    record.abscissae.push_back(times[row]);
    record.values.push_back(loads[row] / (strain * (is_force ? cross_section : 1.)));
  }
  record.noise_units = record.values;
  check_bar_record(table, record, record.values.size(), section, "Strain");
  return test;
}
} // namespace Continua
