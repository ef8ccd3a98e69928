#include <continua/base/csv_table.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <functional>
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
  bool in_brackets = false, in_quotes = false;
  for (const char character : separator == ' ' ? trim(line) : line)
  {
    if (character == '"')
      in_quotes = !in_quotes;
    if (character == '[' || character == ']')
      in_brackets = (character == '[');
    if (character != separator || in_brackets || in_quotes)
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
} // namespace

CsvTable::CsvTable(const std::string &file, const std::string &example) : file(file)
{
  Origin origin{file, 0};
  std::ifstream stream(file);
  if (!stream)
    throw InputError(origin, "", "the file cannot be read", "Check the path and the permissions");

  std::string line;
  if (!next_line(stream, line, origin.line))
    throw InputError({file, 0}, "", "the file has no header",
                     "Write a first line such as '" + example + "'");
  header_line = origin.line;
  const char separator = find_separator(line);
  columns = parse_header(line, separator);

  while (next_line(stream, line, origin.line))
  {
    rows.push_back({origin.line, split(line, separator)});
    const std::size_t n_cells = rows.back().cells.size();
    if (n_cells != columns.size())
      throw InputError(origin, "",
                       "the row has " + std::to_string(n_cells) + " cells, the header " +
                           std::to_string(columns.size()),
                       "Give every row one number per column, with the header's separator and a "
                       "decimal point");
  }
}

std::vector<CsvTable::Column> CsvTable::parse_header(const std::string &line, const char separator)
{
  std::vector<Column> columns;
  for (std::string cell : split(line, separator))
  {
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"')
      cell = cell.substr(1, cell.size() - 2);
    // Where blanks separate, the unit stands in a cell of its own.
    if (separator == ' ' && cell[0] == '[' && !columns.empty() && !columns.back().has_unit)
    {
      cell.insert(0, columns.back().name);
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

std::string CsvTable::names(const std::size_t first) const
{
  std::string text;
  for (std::size_t i = first; i < columns.size(); ++i)
    text += (i > first ? ", '" : "'") + columns[i].name + "'";
  return text;
}

std::size_t CsvTable::find(const std::string &name, const std::size_t first) const
{
  std::size_t found = columns.size();
  for (std::size_t i = first; i < columns.size(); ++i)
    if (columns[i].name == name)
    {
      if (found != columns.size())
        throw InputError(header(), name, "two columns have this name", "Rename one of them");
      found = i;
    }
  if (found == columns.size())
    throw InputError(header(), name, "there is no such column of values",
                     "The columns are " + names(first));
  return found;
}

double CsvTable::unit_factor_of(const std::size_t number, const Dimension &dimension) const
{
  const Column &column = columns[number];
  if (!column.has_unit && dimension == Dimensions::none)
    return 1.;
  const std::string remedy =
      "Write the header as '" + (column.name.empty() ? "NAME" : column.name) + " [UNIT]'" +
      (dimension == Dimensions::none ? " or without a unit"
                                     : " with a unit of the dimension of " + dimension.unit());
  if (!column.has_unit)
    throw InputError(header(), column.name, "the column has no unit", remedy);
  try
  {
    Dimension found;
    const double factor = unit_factor(column.unit, found);
    if (found == dimension)
      return factor;
  }
  catch (const std::invalid_argument &exception)
  {
    throw InputError(header(), column.name, exception.what(), remedy);
  }
  throw InputError(header(), column.name,
                   "the unit '" + column.unit + "' is not of the dimension of " + dimension.unit(),
                   remedy);
}

std::vector<double> CsvTable::values(const std::size_t column, const Dimension &dimension) const
{
  const double factor = unit_factor_of(column, dimension);
  std::vector<double> values;
  values.reserve(rows.size());
  for (const Row &row : rows)
    values.push_back(factor *
                     read_number({file, row.line}, columns[column].name, row.cells[column]));
  return values;
}

std::vector<double> CsvTable::increasing_values(const std::size_t column,
                                                const Dimension &dimension,
                                                const std::string &time,
                                                const std::string &later) const
{
  std::vector<double> numbers = values(column, dimension);
  const auto pair = std::adjacent_find(numbers.begin(), numbers.end(), std::greater_equal<>());
  if (pair != numbers.end())
  {
    const std::size_t row = pair - numbers.begin() + 1;
    refuse(row, column,
           "the " + time + " " + rows[row].cells[column] + " is not " + later +
               " than that of the row before",
           "Sort the rows by " + time + " and remove double ones");
  }
  return numbers;
}

void CsvTable::require_rows(const std::size_t n) const
{
  if (rows.size() < n)
    throw InputError({file, 0}, "", "the table has " + std::to_string(rows.size()) + " rows",
                     "Give " + std::to_string(n) + " at least");
}

void CsvTable::refuse(const std::size_t row,
                      const std::size_t column,
                      const std::string &problem,
                      const std::string &remedy) const
{
  throw InputError({file, rows[row].line}, column < columns.size() ? columns[column].name : "",
                   problem, remedy);
}
} // namespace Continua
