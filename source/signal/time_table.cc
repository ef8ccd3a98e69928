#include <continua/signal/time_table.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Continua
{
namespace
{
/// Of a period, by which the time from the first to the last row may differ from it.
constexpr double period_slack = 1e-9;

std::size_t
choose_column(const CsvTable &table, const std::string &example, const std::string &name)
{
  if (table.n_columns() < 2)
    throw InputError(table.header(), "", "the header has one column, expected are time and a value",
                     "Write a first line such as '" + example + "' that does not start with #");
  if (table.name(0).empty() && !table.has_unit(0) && table.n_columns() > 2)
    throw InputError(
        table.header(), "", "the first column has no name and no unit, and it should be the time",
        "Remove this column, as 'cut -d , -f 2- FILE > NEW' does where commas separate, "
        "or give it a name and a unit");
  if (!name.empty())
    return table.find(name, 1);
  if (table.n_columns() > 2)
    throw InputError(table.header(), "", "there are several columns: " + table.names(1),
                     "Choose one with 'Column'");
  return 1;
}

/// A header for values of that dimension.
std::string example_of(const Dimension &dimension)
{
  if (dimension == Dimensions::pressure)
    return "time [ms], pressure [mmHg]";
  return dimension == Dimensions::flow_rate ? "time [s], flow [ml/s]"
                                            : "time [s], value [" + dimension.unit() + "]";
}
} // namespace

std::string scaling_advice(const std::string &key)
{
  return ". '" + key +
         "' multiplies the values: -1 turns their sign, and another number converts a unit that is "
         "not known here";
}

TimeTable::TimeTable(const std::string &file,
                     const Dimension &dimension,
                     const Reading &reading,
                     const std::string &column)
    : reading(reading)
{
  const std::string example = example_of(dimension);
  const CsvTable table(file, example, scaling_advice(reading.factor_key));
  *this = TimeTable(table, choose_column(table, example, column), dimension, reading);
}

TimeTable::TimeTable(const CsvTable &table,
                     const std::size_t column,
                     const Dimension &dimension,
                     const Reading &reading)
    : reading(reading)
{
  std::vector<double> times = table.increasing_values(0, Dimensions::time, "time", "later");
  std::vector<double> numbers = table.values(column, dimension);
  table.require_rows(2);
  for (double &number : numbers)
    number = reading.factor * number + reading.offset;
  length = times.back() - times.front();
  for (double &time : times)
    time += reading.shift;
  begin = times.front();
  end = times.back();
  const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
  const double range = *high - *low;
  if (reading.period > 0.)
  {
    if (length > reading.period * (1. + period_slack))
      table.refuse(table.n_rows() - 1, 0,
                   "this row is " + period_text() +
                       " later than the first one, more than the period of " +
                       shortest_number(reading.period) + " s",
                   "Give a longer '" + reading.period_key + "', or end the table before");
    if (length < reading.period * (1. - period_slack))
    {
      times.push_back(begin + reading.period);
      numbers.push_back(numbers.front());
      length = reading.period;
    }
  }
  range_of_values = range;
  jump_of_period = range > 0. ? std::abs(numbers.back() - numbers.front()) / range : 0.;
  values = Interpolant(times, numbers, reading.interpolation,
                       reading.after == Outside::repeat && numbers.front() == numbers.back());
}

std::string TimeTable::period_text() const
{
  // A difference of two times has round-off in its last digits.
  std::ostringstream text;
  text.precision(12);
  text << length << " s";
  return text.str();
}

double TimeTable::operator()(double time) const
{
  if (time >= begin && time <= end)
    return values(time);
  const bool is_before = time < begin;
  switch (is_before ? reading.before : reading.after)
  {
  case Outside::hold:
    return values(is_before ? begin : end);
  case Outside::repeat:
  {
    const double past = std::fmod(time - begin, length);
    return values(begin + (past < 0. ? past + length : past));
  }
  case Outside::zero:
    return 0.;
  default:
    return std::numeric_limits<double>::quiet_NaN();
  }
}
} // namespace Continua
