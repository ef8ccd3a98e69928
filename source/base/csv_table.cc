#include <continua/base/csv_table.h>
#include <continua/base/input_file.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
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

/// Whether the line is neither empty nor a comment.
bool has_content(const std::string &line)
{
  const std::string content = trim(line);
  return !content.empty() && content[0] != '#';
}

/// The separator that Excel names in a first line "sep=;"; 0 if it is no such line.
char separator_of_excel(const std::string &line)
{
  std::string text = trim(line);
  if (text.size() > 1 && text.front() == '"' && text.back() == '"')
    text = text.substr(1, text.size() - 2);
  return text.size() == 5 && text.compare(0, 4, "sep=") == 0 ? text[4] : '\0';
}

/// Whether a person can mean it as the name of a column; what is shown of another file, named by
/// mistake, may be a secret.
bool is_plain_name(const std::string &name)
{
  return name.size() <= 40 &&
         std::all_of(name.begin(), name.end(),
                     [](const char letter)
                     {
                       return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
                              static_cast<unsigned char>(letter) >= 0x80 ||
                              std::string(" .,:_-+/()'").find(letter) != std::string::npos;
                     });
}

/// The unit in round brackets at the end of a name, which many programs write; empty if there is
/// none that is known. `open`: where the bracket stands.
std::string unit_in_round_brackets(const std::string &cell, std::size_t &open)
{
  open = cell.rfind('(');
  if (open == std::string::npos || open == 0 || cell.back() != ')')
    return "";
  const std::string unit = trim(cell.substr(open + 1, cell.size() - open - 2));
  try
  {
    Dimension ignored;
    unit_factor(unit, ignored);
    return unit;
  }
  catch (const std::invalid_argument &)
  {
    return "";
  }
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
    throw InputError(origin, column,
                     (is_plain_name(cell) ? "'" + cell + "'" : "the cell") + " is not a number",
                     "Write a finite number with a decimal point and no unit, such as -1.5e-3");
  return number;
}
} // namespace

CsvTable::CsvTable(const std::string &file, const std::string &example) : file(file)
{
  const std::vector<std::string> lines = read_input_lines(file);
  const std::string remedy = "Write a first line such as '" + example + "'";
  char separator = lines.empty() ? '\0' : separator_of_excel(lines.front());
  std::size_t i = separator == '\0' ? 0 : 1;
  while (i < lines.size() && !has_content(lines[i]))
    ++i;
  if (i == lines.size())
    throw InputError({file, 0}, "", lines.empty() ? "the file is empty" : "the file has no header",
                     remedy);
  header_line = static_cast<unsigned int>(i + 1);
  if (separator == '\0')
    separator = find_separator(lines[i]);
  columns = parse_header(lines[i], separator);

  for (++i; i < lines.size(); ++i)
    if (has_content(lines[i]))
    {
      const unsigned int line = static_cast<unsigned int>(i + 1);
      rows.push_back({line, split(lines[i], separator)});
      const std::size_t n_cells = rows.back().cells.size();
      if (n_cells != columns.size())
        throw InputError({file, line}, "",
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
    const bool is_unit = cell[0] == '[' || (cell[0] == '(' && cell.back() == ')');
    if (separator == ' ' && is_unit && !columns.empty() && !columns.back().has_unit)
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
    std::size_t round_open = 0;
    if (const std::string unit = unit_in_round_brackets(cell, round_open);
        open == std::string::npos && !unit.empty())
    {
      column.name = trim(cell.substr(0, round_open));
      column.unit = unit;
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
    text += (i > first ? ", " : "") + (is_plain_name(columns[i].name)
                                           ? "'" + columns[i].name + "'"
                                           : "number " + std::to_string(i + 1));
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
