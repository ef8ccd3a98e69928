#include <continua/materials/relaxation_test.h>

#include <continua/base/csv_table.h>

#include <gsl/gsl_fit.h>

#include <cmath>
#include <limits>

namespace Continua
{
namespace
{
constexpr Dimension force{1, 1, -2};

/// The column of that name, or the number of columns if there is none.
std::size_t find_column(const CsvTable &table, const std::string &name)
{
  for (std::size_t column = 0; column < table.n_columns(); ++column)
    if (table.name(column) == name)
      return table.find(name);
  return table.n_columns();
}

/// The column of the force or stress; `is_force` tells which.
std::size_t find_load(const CsvTable &table, const std::string &example, bool &is_force)
{
  const std::size_t force_column = find_column(table, "force");
  const std::size_t stress_column = find_column(table, "stress");
  is_force = force_column < table.n_columns();
  if (is_force == (stress_column < table.n_columns()))
    throw InputError(table.header(), "",
                     std::string(is_force ? "both 'force' and 'stress' are columns"
                                          : "neither 'force' nor 'stress' is a column") +
                         "; the columns are " + table.names(),
                     "Give one of them, as in '" + example + "'");
  return is_force ? force_column : stress_column;
}

void read_table(const ParameterSection &section, const double cross_section, RelaxationTest &test)
{
  const std::string example = "time [s], force [N]";
  const CsvTable table(test.file, example);
  const std::size_t time_column = table.find("time");
  bool is_force = false;
  const std::size_t load_column = find_load(table, example, is_force);
  if (is_force)
    section.require("Cross-section");
  else if (section.given("Cross-section"))
    section.refuse("Cross-section", "the relaxation table has stresses, which need none",
                   "Remove it");
  test.times = table.increasing_values(time_column, Dimensions::time, "time", "later");
  test.moduli = table.values(load_column, is_force ? force : Dimensions::pressure);
  for (double &modulus : test.moduli)
  {
    modulus /= test.strain * (is_force ? cross_section : 1.);
    // Far beyond every material there is, and where powers of it can no longer be held.
    constexpr double largest_modulus = 1e15, smallest_modulus = 1e-9;
    if (std::abs(modulus) > largest_modulus ||
        (modulus != 0. && std::abs(modulus) < smallest_modulus))
      section.refuse("Strain",
                     "with this strain the table gives a modulus of " + shortest_number(modulus) +
                         " Pa, which no material has",
                     "Check the strain, the cross-section and the units of the table");
  }

  while (test.first_used < test.times.size() &&
         (test.times[test.first_used] <= 0. ||
          test.times[test.first_used] < loading_times_left_out * test.loading_time))
    ++test.first_used;
  for (std::size_t row = test.first_used; row < test.times.size(); ++row)
    if (!(test.moduli[row] > 0.))
      table.refuse(row, load_column,
                   "the " + table.name(load_column) + " of a strain that is held must be positive",
                   "Remove the row, or turn the sign of all");
  if (test.times.size() < test.first_used + 3)
    throw InputError(
        table.header(), "",
        "the table has " + std::to_string(test.times.size() - test.first_used) +
            " rows to fit a power law to; left out are those up to time 0 and before " +
            shortest_number(loading_times_left_out) + " loading times",
        "Give three or more rows later than that, or a shorter 'Loading time'");
}
} // namespace

RelaxationTest read_relaxation_test(ParameterSection section)
{
  RelaxationTest test;
  section.add_input_file("Relaxation table", test.file,
                         "A csv file of a relaxation test with the columns time and force or "
                         "stress, units in its header; c and n are fitted to it.");
  double cross_section = std::numeric_limits<double>::quiet_NaN();
  section.add("Cross-section", cross_section, Dimensions::area,
              "Cross-section of the specimen of the relaxation table; required for forces.",
              Range::positive());
  test.strain = std::numeric_limits<double>::quiet_NaN();
  section.add("Strain", test.strain, Dimensions::none,
              "Strain that is held in the test of the relaxation table; required for a table.",
              Range::positive());
  section.add("Loading time", test.loading_time, Dimensions::time,
              "Time in which the strain of the relaxation table rises from 0, at time 0, evenly; "
              "rows before 5 of these times are left out, and the law counts from the middle of "
              "the loading.",
              Range::not_negative());
  if (test.file.empty())
  {
    for (const char *key : {"Cross-section", "Strain", "Loading time"})
      if (section.given(key))
        section.refuse(key, "there is no relaxation table to which this belongs",
                       "Add 'set Relaxation table = FILE', or remove it");
    return test;
  }
  section.require("Strain");
  read_table(section, cross_section, test);
  return test;
}

RelaxationFit fit_relaxation_test(const RelaxationTest &test)
{
  std::vector<double> log_times, log_moduli;
  for (std::size_t row = test.first_used; row < test.times.size(); ++row)
  {
    log_times.push_back(std::log(test.law_time(row)));
    log_moduli.push_back(std::log(test.moduli[row]));
  }
  double intercept = 0., slope = 0., covariance[3], sum = 0.;
  gsl_fit_linear(log_times.data(), 1, log_moduli.data(), 1, log_times.size(), &intercept, &slope,
                 &covariance[0], &covariance[1], &covariance[2], &sum);
  // A difference, since the negative of the slope 0 of a constant load is printed as -0.
  return {std::exp(intercept), 0. - slope, std::sqrt(sum / log_times.size())};
}
} // namespace Continua
