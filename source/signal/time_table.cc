#include <continua/base/input_error.h>
#include <continua/signal/time_table.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace Continua
{
namespace
{
std::string trim(const std::string &text)
{
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos)
    return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The next line that is neither empty nor a comment; `line` is its number.
bool next_line(std::istream &stream, std::string &text, unsigned int &line)
{
  while (std::getline(stream, text))
  {
    ++line;
    if (line == 1 && text.compare(0, 3, "\xEF\xBB\xBF") == 0)
      text.erase(0, 3);
    if (!text.empty() && text.back() == '\r')
      text.pop_back();
    const std::string content = trim(text);
    if (!content.empty() && content[0] != '#')
      return true;
  }
  return false;
}

/// Cells of a line, trimmed. A separator inside brackets, as in "[mPa s]", does not separate;
/// `separator` ' ' stands for any number of blanks.
std::vector<std::string> split(const std::string &line, const char separator)
{
  std::vector<std::string> cells(1);
  bool in_brackets = false;
  for (const char character : separator == ' ' ? trim(line) : line)
  {
    if (character == '[' || character == ']')
      in_brackets = (character == '[');
    if (character != separator || in_brackets)
      cells.back() += character;
    else if (separator != ' ' || !cells.back().empty())
      cells.emplace_back();
  }
  for (std::string &cell : cells)
    cell = trim(cell);
  return cells;
}

char find_separator(const std::string &header)
{
  for (const char candidate : {';', ',', '\t'})
    if (split(header, candidate).size() > 1)
      return candidate;
  return ' ';
}

struct Column
{
  std::string name;
  std::string unit;
  bool has_unit = false;
};

std::vector<Column> parse_header(const std::string &line, const char separator)
{
  std::vector<Column> columns;
  for (std::string cell : split(line, separator))
  {
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"')
      cell = cell.substr(1, cell.size() - 2);
    // Where blanks separate, the unit stands in a cell of its own.
    if (separator == ' ' && cell[0] == '[' && !columns.empty() && !columns.back().has_unit)
    {
      cell = columns.back().name + cell;
      columns.pop_back();
    }
    Column column;
    const std::size_t open = cell.find('[');
    column.name = trim(cell.substr(0, open));
    if (open != std::string::npos && cell.back() == ']')
    {
      column.unit = trim(cell.substr(open + 1, cell.size() - open - 2));
      column.has_unit = true;
    }
    columns.push_back(column);
  }
  return columns;
}

double read_factor(const Origin &origin, const Column &column, const Dimension &dimension)
{
  if (!column.has_unit && dimension == Dimensions::none)
    return 1.;
  const std::string remedy =
      "Write the header as '" + (column.name.empty() ? "NAME" : column.name) + " [UNIT]'" +
      (dimension == Dimensions::none ? " or without a unit"
                                     : " with a unit of the dimension of " + dimension.unit());
  if (!column.has_unit)
    throw InputError(origin, column.name, "the column has no unit", remedy);
  try
  {
    Dimension found;
    const double factor = unit_factor(column.unit, found);
    if (found == dimension)
      return factor;
  }
  catch (const std::invalid_argument &exception)
  {
    throw InputError(origin, column.name, exception.what(), remedy);
  }
  throw InputError(origin, column.name,
                   "the unit '" + column.unit + "' is not of the dimension of " + dimension.unit(),
                   remedy);
}

std::size_t
choose_column(const Origin &origin, const std::vector<Column> &columns, const std::string &name)
{
  const std::string example = "'time [ms], pressure [mmHg]'";
  if (columns.size() < 2)
    throw InputError(origin, "", "the header has one column, expected are time and a value",
                     "Write a first line such as " + example + " that does not start with #");
  std::string names;
  for (std::size_t i = 1; i < columns.size(); ++i)
    names += (i > 1 ? ", '" : "'") + columns[i].name + "'";
  if (name.empty())
  {
    if (columns.size() > 2)
      throw InputError(origin, "", "there are several columns: " + names,
                       "Choose one with 'Column'");
    return 1;
  }
  std::size_t chosen = 0;
  for (std::size_t i = 1; i < columns.size(); ++i)
    if (columns[i].name == name)
    {
      if (chosen != 0)
        throw InputError(origin, name, "two columns have this name", "Rename one of them");
      chosen = i;
    }
  if (chosen == 0)
    throw InputError(origin, name, "there is no such column of values", "The columns are " + names);
  return chosen;
}

double read_number(const Origin &origin, const std::string &column, const std::string &cell)
{
  if (cell.empty())
    throw InputError(origin, column, "the value is missing", "Fill it in, or remove the line");
  const char *const begin = cell.data() + (cell[0] == '+' ? 1 : 0);
  const char *const end = cell.data() + cell.size();
  double number = 0.;
  const auto result = std::from_chars(begin, end, number);
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(number))
    throw InputError(origin, column, "'" + cell + "' is not a number",
                     "Write a finite number with a decimal point and no unit, such as -1.5e-3");
  return number;
}

/// The slope at the row between two intervals of lengths h0, h1 and slopes d0, d1: zero at an
/// extremum, else their weighted harmonic mean, which keeps the interpolant monotone (Fritsch and
/// Butland 1984).
double inner_slope(const double h0, const double d0, const double h1, const double d1)
{
  if (d0 * d1 <= 0.)
    return 0.;
  const double w0 = h0 + 2. * h1;
  const double w1 = 2. * h0 + h1;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

/// The slope at an end, next to the interval (h0, d0): of the parabola through three rows, limited
/// to keep the interpolant monotone.
double end_slope(const double h0, const double d0, const double h1, const double d1)
{
  const double slope = ((2. * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0.)
    return 0.;
  return std::abs(slope) > 3. * std::abs(d0) ? 3. * d0 : slope;
}

std::vector<double> monotone_slopes(const std::vector<double> &times,
                                    const std::vector<double> &values,
                                    const bool periodic)
{
  const std::size_t n_intervals = times.size() - 1;
  std::vector<double> lengths(n_intervals), secants(n_intervals);
  for (std::size_t i = 0; i < n_intervals; ++i)
  {
    lengths[i] = times[i + 1] - times[i];
    secants[i] = (values[i + 1] - values[i]) / lengths[i];
  }
  std::vector<double> slopes(times.size(), secants[0]);
  if (n_intervals == 1)
    return slopes;

  for (std::size_t i = 1; i < n_intervals; ++i)
    slopes[i] = inner_slope(lengths[i - 1], secants[i - 1], lengths[i], secants[i]);
  const std::size_t last = n_intervals - 1;
  if (periodic)
    slopes.front() = slopes.back() =
        inner_slope(lengths[last], secants[last], lengths[0], secants[0]);
  else
  {
    slopes.front() = end_slope(lengths[0], secants[0], lengths[1], secants[1]);
    slopes.back() = end_slope(lengths[last], secants[last], lengths[last - 1], secants[last - 1]);
  }
  return slopes;
}
} // namespace

TimeTable::TimeTable(const std::string &file,
                     const Dimension &dimension,
                     const Interpolation interpolation,
                     const After after,
                     const double offset,
                     const std::string &column)
    : interpolation(interpolation), after(after)
{
  Origin origin{file, 0};
  std::ifstream stream(file);
  if (!stream)
    throw InputError(origin, "", "the file cannot be read", "Check the path and the permissions");

  std::string line;
  if (!next_line(stream, line, origin.line))
    throw InputError({file, 0}, "", "the file has no header",
                     "Write a first line such as 'time [ms], pressure [mmHg]'");
  const char separator = find_separator(line);
  const std::vector<Column> columns = parse_header(line, separator);
  const std::size_t chosen = choose_column(origin, columns, column);
  const double time_factor = read_factor(origin, columns[0], Dimensions::time);
  const double value_factor = read_factor(origin, columns[chosen], dimension);

  while (next_line(stream, line, origin.line))
  {
    const std::vector<std::string> cells = split(line, separator);
    if (cells.size() != columns.size())
      throw InputError(origin, "",
                       "the row has " + std::to_string(cells.size()) + " cells, the header " +
                           std::to_string(columns.size()),
                       "Give every row one number per column, with the header's separator and a "
                       "decimal point");
    const double time = time_factor * read_number(origin, columns[0].name, cells[0]);
    if (!times.empty() && time <= times.back())
      throw InputError(origin, columns[0].name,
                       "the time " + cells[0] + " is not later than that of the row before",
                       "Sort the rows by time and remove double ones");
    times.push_back(time);
    values.push_back(value_factor * read_number(origin, columns[chosen].name, cells[chosen]) +
                     offset);
  }
  if (times.size() < 2)
    throw InputError({file, 0}, "", "the table has " + std::to_string(times.size()) + " rows",
                     "Give two at least");
  if (interpolation == Interpolation::cubic)
    slopes =
        monotone_slopes(times, values, after == After::repeat && values.front() == values.back());
}

double TimeTable::operator()(double time) const
{
  if (time <= times.front())
    return values.front();
  if (time > times.back() && after == After::repeat)
    time = times.front() + std::fmod(time - times.front(), times.back() - times.front());
  if (time >= times.back())
    return time > times.back() && after == After::zero ? 0. : values.back();

  const std::size_t i = std::upper_bound(times.begin(), times.end(), time) - times.begin() - 1;
  const double length = times[i + 1] - times[i];
  const double s = (time - times[i]) / length;
  if (interpolation == Interpolation::linear)
    return (1. - s) * values[i] + s * values[i + 1];
  // Hermite's cubic, as the chord and a bubble that brings in the slopes.
  const double chord = values[i + 1] - values[i];
  const double start = slopes[i] * length - chord;
  const double end = chord - slopes[i + 1] * length;
  return values[i] + s * chord + s * (1. - s) * (start * (1. - s) + end * s);
}

double TimeTable::first_time() const
{
  return times.front();
}

double TimeTable::last_time() const
{
  return times.back();
}
} // namespace Continua
