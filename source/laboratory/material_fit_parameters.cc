#include <continua/laboratory/material_fit_parameters.h>

#include <continua/base/csv_table.h>
#include <continua/base/words.h>
#include <continua/case/theory/bar_tables.h>
#include <continua/theory/bar_law.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace Continua
{
namespace
{
const Words<TableNoise> &noise_words()
{
  static const Words<TableNoise> words = {{"relative", TableNoise::relative},
                                          {"even", TableNoise::even}};
  return words;
}

/// Of a value that is not positive, whose logarithm a fit with relative noise needs.
std::string remedy_of_sign(const TableNoise noise)
{
  return noise == TableNoise::relative
             ? "Remove the row, change the sign of all values, or set Noise = even"
             : "";
}

void set_even_noise(BarRecord &record)
{
  double largest = 0.;
  for (const double value : record.values)
    largest = std::max(largest, std::abs(value));
  record.noise_units.assign(record.values.size(), largest);
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
  if (const auto test = BarRelaxation::read(section, remedy_of_sign(noise)))
    take(test->record, "Relaxation table", test->n_left_out);
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
  const std::vector<double> times = times_of_bar_table(table);
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
    require_positive_value(table, row, column, strains[row], remedy_of_sign(noise));
    record.abscissae.push_back(times[row]);
    record.values.push_back(strains[row] / stress);
  }
  record.noise_units = record.values;
  check_bar_record(table, record, record.values.size(), section, "Stress");
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
  check_bar_record(table, record, frequencies.size(), section, "Modulus table");
  take(record, "Modulus table", 0);
}

void MaterialFitParameters::read(ParameterSection section)
{
  const std::string best = "best";
  std::vector<std::string> choices = bar_law_types();
  choices.insert(choices.begin(), best);
  std::string type = best;
  section.add_choice("Law", type, choices,
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
  if (type != best)
    law = make_bar_law(type, poissons_ratio, std::max(n_branches, 1u));
  else if (n_branches > 0)
    law = make_series_of_bar(poissons_ratio, n_branches);
  if (n_branches > 0 && law->n_branches() == 0)
    section.refuse("Branches", "the law '" + type + "' has no branches",
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
