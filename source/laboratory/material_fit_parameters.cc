#include <continua/laboratory/material_fit_parameters.h>

#include <continua/base/csv_table.h>
#include <continua/base/words.h>
#include <continua/theory/bar_law.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace Continua
{
namespace
{
constexpr Dimension force_of_a_bar{1, 1, -2};
/// A table of fewer values tells no noise.
constexpr std::size_t fewest_rows = 3;

const Words<TableNoise> &noise_words()
{
  static const Words<TableNoise> words = {{"relative", TableNoise::relative},
                                          {"even", TableNoise::even}};
  return words;
}

bool has_column(const CsvTable &table, const std::string &name)
{
  for (std::size_t column = 0; column < table.n_columns(); ++column)
    if (table.name(column) == name)
      return true;
  return false;
}

/// Times since the start of the load; refuses those before it.
std::vector<double> times_of_table(const CsvTable &table)
{
  const std::size_t column = table.find("time");
  const std::vector<double> times =
      table.increasing_values(column, Dimensions::time, "time", "later");
  if (!times.empty() && times.front() < 0.)
    table.refuse(0, column, "the time is negative: the load begins at time 0",
                 "Let time 0 be the start of the load, and remove the rows before it");
  return times;
}

/// Refuses a value that is not positive, which the logarithm of a law, or noise that is a share of
/// the value, would need.
void require_positive(const CsvTable &table,
                      const std::size_t row,
                      const std::size_t column,
                      const double value,
                      const TableNoise noise)
{
  if (noise == TableNoise::relative && !(value > 0.))
    table.refuse(row, column,
                 "the " + table.name(column) + " must be positive where the noise is relative",
                 "Remove the row, change the sign of all values, or set Noise = even");
}

void set_even_noise(BarRecord &record)
{
  double largest = 0.;
  for (const double value : record.values)
    largest = std::max(largest, std::abs(value));
  record.noise_units.assign(record.values.size(), largest);
}

/// `key`: the entry by which the values of the table were divided.
void check_rows(const CsvTable &table,
                const BarRecord &record,
                const std::size_t n_rows,
                const ParameterSection &section,
                const std::string &key)
{
  if (n_rows < fewest_rows)
    throw InputError(table.header(), "",
                     "the table has " + std::to_string(n_rows) +
                         " rows that can be used, and a fit needs " + std::to_string(fewest_rows) +
                         "; rows up to the end of the loading are not used",
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
} // namespace

void MaterialFitParameters::take(const BarRecord &record,
                                 const std::string &key,
                                 const std::size_t left_out)
{
  records.push_back(record);
  if (noise == TableNoise::even)
    set_even_noise(records.back());
  else
    records.back().is_logarithmic = record.quantity != BarQuantity::modulus;
  keys.push_back(key);
  n_left_out.push_back(left_out);
}

void MaterialFitParameters::read_relaxation(ParameterSection &section)
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
    return;
  }
  section.require("Strain");
  const CsvTable table(file, "time [s], stress [kPa]");
  const std::vector<double> times = times_of_table(table);
  const bool is_force = has_column(table, "force");
  if (is_force == has_column(table, "stress"))
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
  BarRecord record;
  record.loading_time = loading_time;
  std::size_t left_out = 0;
  for (std::size_t row = 0; row < times.size(); ++row)
  {
    if (times[row] <= loading_time)
    {
      ++left_out;
      continue;
    }
    require_positive(table, row, column, loads[row], noise);
    record.abscissae.push_back(times[row]);
    record.values.push_back(loads[row] / (strain * (is_force ? cross_section : 1.)));
  }
  record.noise_units = record.values;
  check_rows(table, record, record.values.size(), section, "Strain");
  take(record, "Relaxation table", left_out);
}

void MaterialFitParameters::read_creep(ParameterSection &section)
{
  std::string file;
  section.add_input_file("Creep table", file,
                         "A csv file of a creep test with the columns time and strain, units in "
                         "its header. The stress is there from time 0 on.");
  double stress = std::numeric_limits<double>::quiet_NaN();
  section.add("Stress", stress, Dimensions::pressure,
              "Stress that is held in the creep table. Required for this table.",
              Range::positive());
  if (file.empty())
  {
    if (section.given("Stress"))
      section.refuse("Stress", "there is no creep table to which this belongs",
                     "Add 'set Creep table = FILE', or remove it");
    return;
  }
  section.require("Stress");
  const CsvTable table(file, "time [s], strain [1]");
  const std::vector<double> times = times_of_table(table);
  const std::size_t column = table.find("strain");
  const std::vector<double> strains = table.values(column, Dimensions::none);
  BarRecord record;
  record.quantity = BarQuantity::creep;
  std::size_t left_out = 0;
  for (std::size_t row = 0; row < times.size(); ++row)
  {
    if (times[row] == 0.)
    {
      ++left_out;
      continue;
    }
    require_positive(table, row, column, strains[row], noise);
    record.abscissae.push_back(times[row]);
    record.values.push_back(strains[row] / stress);
  }
  record.noise_units = record.values;
  check_rows(table, record, record.values.size(), section, "Stress");
  take(record, "Creep table", left_out);
}

void MaterialFitParameters::read_moduli(ParameterSection &section)
{
  std::string file;
  section.add_input_file(
      "Modulus table", file,
      "A csv file with the columns frequency, storage modulus and loss modulus (of Young's "
      "modulus), units in its header, such as modulus.csv of Analysis = material.");
  if (file.empty())
    return;
  const CsvTable table(file, "frequency [Hz], storage modulus [kPa], loss modulus [kPa]");
  const std::size_t frequency_column = table.find("frequency"),
                    storage_column = table.find("storage modulus"),
                    loss_column = table.find("loss modulus");
  const std::vector<double> frequencies = table.increasing_values(
                                frequency_column, Dimensions::frequency, "frequency", "higher"),
                            storage = table.values(storage_column, Dimensions::pressure),
                            loss = table.values(loss_column, Dimensions::pressure);
  const bool is_negative = std::accumulate(loss.begin(), loss.end(), 0.) < 0.;
  BarRecord record;
  record.quantity = BarQuantity::modulus;
  for (std::size_t row = 0; row < frequencies.size(); ++row)
  {
    if (!(frequencies[row] > 0.))
      table.refuse(row, frequency_column, "a frequency must be positive", "Remove the row");
    if (!(storage[row] > 0.))
      table.refuse(row, storage_column, "the storage modulus of a solid is positive",
                   "Check the columns and their signs");
    if (is_negative && loss[row] < 0.)
      table.refuse(row, loss_column, "the loss modulus of a solid is positive",
                   "Change the sign of the column");
    const double magnitude = std::hypot(storage[row], loss[row]);
    for (const double value : {storage[row], loss[row]})
    {
      record.abscissae.push_back(frequencies[row]);
      record.values.push_back(value);
      record.noise_units.push_back(magnitude);
    }
  }
  check_rows(table, record, frequencies.size(), section, "Modulus table");
  take(record, "Modulus table", 0);
}

void MaterialFitParameters::read(ParameterSection section)
{
  std::vector<std::string> laws = BarLaw::types();
  laws.insert(laws.begin(), "best");
  section.add_choice("Law", law, laws,
                     "The law that is written as a material: best - the one with the least "
                     "information criterion, where the Prony series has its fewest branches by "
                     "the rule of 'Branches'; or a Type of a material. All laws are fitted and "
                     "compared.");
  section.add("Branches", n_branches,
              "Branches of the Prony series beside its spring [1]; 0: the fewest whose "
              "information criterion is at most 2 above the least one. More than 0 take the Prony "
              "series, also with Law = best.",
              0, 20);
  section.add("Most branches", most_branches,
              "Most branches that are tried [1]. A series with more constants than half of the "
              "values of the tables is left out.",
              1, 20);
  section.add("Poisson's ratio", poissons_ratio, Dimensions::none,
              "Poisson's ratio nu of the material, which these tests do not show; 0.5 is "
              "incompressible. Of laws that relax it is the same at all times.",
              Range{0., 0.5});
  section.add("Density", density, Dimensions::density, "Density of the material that is written.",
              Range::positive());
  add_choice(section, "Noise", noise, noise_words(),
             "relative - a share of each value (of storage and loss modulus of the magnitude of "
             "both), which is found for each table; even - the same in all rows of a table.");
  read_relaxation(section);
  read_creep(section);
  read_moduli(section);
  if (n_branches > most_branches)
    section.refuse("Branches", "there are more than Most branches",
                   "Give 'Most branches' (default 8) as many at least");
  if (n_branches > 0 && law != "best" && law != "prony")
    section.refuse("Branches", "the law '" + law + "' has no branches",
                   "Remove it, or set Law = prony");
}

std::size_t MaterialFitParameters::n_values() const
{
  std::size_t n = 0;
  for (const BarRecord &record : records)
    n += record.values.size();
  return n;
}
} // namespace Continua
