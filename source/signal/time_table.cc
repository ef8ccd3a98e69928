#include <continua/base/csv_table.h>
#include <continua/signal/time_table.h>

#include <cmath>

namespace Continua
{
namespace
{
const char *const example = "time [ms], pressure [mmHg]";

std::size_t choose_column(const CsvTable &table, const std::string &name)
{
  if (table.n_columns() < 2)
    throw InputError(table.header(), "", "the header has one column, expected are time and a value",
                     std::string("Write a first line such as '") + example +
                         "' that does not start with #");
  if (!name.empty())
    return table.find(name, 1);
  if (table.n_columns() > 2)
    throw InputError(table.header(), "", "there are several columns: " + table.names(1),
                     "Choose one with 'Column'");
  return 1;
}
} // namespace

TimeTable::TimeTable(const std::string &file,
                     const Dimension &dimension,
                     const Interpolation interpolation,
                     const After after,
                     const double offset,
                     const std::string &column)
    : after(after)
{
  const CsvTable table(file, example);
  const std::size_t chosen = choose_column(table, column);
  const std::vector<double> times = table.increasing_values(0, Dimensions::time, "time", "later");
  std::vector<double> numbers = table.values(chosen, dimension);
  table.require_rows(2);
  for (double &number : numbers)
    number += offset;
  values = Interpolant(times, numbers, interpolation,
                       after == After::repeat && numbers.front() == numbers.back());
}

double TimeTable::operator()(double time) const
{
  if (time > last_time() && after == After::repeat)
    time = first_time() + std::fmod(time - first_time(), last_time() - first_time());
  return time > last_time() && after == After::zero ? 0. : values(time);
}

double TimeTable::first_time() const
{
  return values.first_point();
}

double TimeTable::last_time() const
{
  return values.last_point();
}
} // namespace Continua
