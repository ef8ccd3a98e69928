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

/// What stands between quotes, in which a quote is written twice.
std::string bare_cell(const std::string &cell)
{
  if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"')
    return cell;
  std::string text;
  for (std::size_t i = 1; i + 1 < cell.size(); ++i)
  {
    text += cell[i];
    if (cell[i] == '"' && cell[i + 1] == '"' && i + 2 < cell.size())
      ++i;
  }
  return trim(text);
}

/// Cells of a line, trimmed and without their quotes. A separator inside brackets, as in "[mPa s]",
/// does not separate; `separator` ' ' stands for any number of blanks and tabs.
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
    const bool separates = character == separator || (separator == ' ' && character == '\t');
    if (!separates || in_brackets || in_quotes)
      cells.back() += character;
    else if (separator != ' ' || !cells.back().empty())
      cells.emplace_back();
  }
  for (std::string &cell : cells)
    cell = bare_cell(trim(cell));
  return cells;
}

char find_separator(const std::string &header)
{
  for (const char candidate : {';', ',', '\t'})
    if (split(header, candidate).size() > 1)
      return candidate;
  return ' ';
}

/// The cell with the exponent of Fortran, 1.0D-03, written as 1.0e-03.
std::string with_usual_exponent(std::string cell)
{
  const auto is_digit = [&cell](const std::size_t i)
  { return i < cell.size() && std::isdigit(static_cast<unsigned char>(cell[i])) != 0; };
  const std::size_t place = cell.find_first_of("dD");
  if (place == std::string::npos || place == 0 || !(is_digit(place - 1) || cell[place - 1] == '.'))
    return cell;
  const bool has_sign =
      place + 1 < cell.size() && (cell[place + 1] == '+' || cell[place + 1] == '-');
  if (is_digit(place + (has_sign ? 2 : 1)))
    cell[place] = 'e';
  return cell;
}

/// Whether the cell is a finite number, and which.
bool is_number(const std::string &cell, double &number)
{
  const std::string text = with_usual_exponent(cell);
  const char *const begin = text.data() + (!text.empty() && text[0] == '+' ? 1 : 0);
  const char *const end = text.data() + text.size();
  const auto result = std::from_chars(begin, end, number);
  return result.ec == std::errc() && result.ptr == end && std::isfinite(number);
}

double read_number(const Origin &origin, const std::string &column, const std::string &cell)
{
  if (cell.empty())
    throw InputError(origin, column, "the value is missing", "Fill it in, or remove the line");
  double number = 0.;
  if (!is_number(cell, number))
    throw InputError(origin, column,
                     (is_plain_name(cell) ? "'" + cell + "'" : "the cell") + " is not a number",
                     "Write a finite number with a decimal point and no unit, such as -1.5e-3");
  return number;
}

bool are_numbers(const std::vector<std::string> &cells)
{
  double ignored = 0.;
  return std::all_of(cells.begin(), cells.end(),
                     [&](const std::string &cell) { return is_number(cell, ignored); });
}

/// Leaves out empty cells at the end, which a separator at the end of each line makes, beyond the
/// first `n`.
void drop_empty_cells(std::vector<std::string> &cells, const std::size_t n)
{
  while (cells.size() > n && cells.back().empty())
    cells.pop_back();
}

std::vector<std::string> cells_of_line(const std::string &line)
{
  std::vector<std::string> cells = split(line, find_separator(line));
  drop_empty_cells(cells, 1);
  return cells;
}

/// Whether the cells are whole numbers of which the first one says how many rows follow, as some
/// programs write before the rows.
bool count_rows(const std::vector<std::string> &cells, const std::size_t n_rows)
{
  return std::all_of(cells.begin(), cells.end(),
                     [](const std::string &cell) {
                       return !cell.empty() &&
                              cell.find_first_not_of("0123456789") == std::string::npos;
                     }) &&
         cells.front() == std::to_string(n_rows);
}

/// The example of a header, for rows with that many cells and this separator.
std::string header_for(const std::string &example, const std::size_t n_cells, const char separator)
{
  const std::vector<std::string> names = split(example, ',');
  const std::string between = separator == ' '    ? "  "
                              : separator == '\t' ? "\t"
                                                  : std::string(1, separator) + " ";
  std::string header;
  for (std::size_t i = 0; i < std::max(names.size(), n_cells); ++i)
  {
    header += i > 0 ? between : "";
    header += i < names.size() ? names[i] : "value " + std::to_string(i + 1) + " [1]";
  }
  return header;
}
} // namespace

CsvTable::CsvTable(const std::string &file, const std::string &example) : file(file)
{
  const std::vector<std::string> lines = read_input_lines(file);
  const std::string remedy = "Write a first line such as '" + example + "'";
  const char separator_given = lines.empty() ? '\0' : separator_of_excel(lines.front());
  // The lines that are neither empty nor comments.
  std::vector<std::size_t> content;
  for (std::size_t i = separator_given == '\0' ? 0 : 1; i < lines.size(); ++i)
    if (has_content(lines[i]))
      content.push_back(i);
  if (content.empty())
    throw InputError({file, 0}, "", lines.empty() ? "the file is empty" : "the file has no header",
                     remedy);

  std::size_t first_row = 1;
  std::string header_text = lines[content.front()];
  header_line = static_cast<unsigned int>(content.front() + 1);
  if (are_numbers(cells_of_line(header_text)))
  {
    first_row = 0;
    header_text = header_in_comment(lines, content.front());
    if (header_text.empty())
      refuse_without_header(lines, content, example);
  }
  const char separator = separator_given == '\0' ? find_separator(header_text) : separator_given;
  columns = parse_header(header_text, separator);

  const auto cells_of = [&](const std::string &line, const char of_rows)
  {
    std::vector<std::string> cells = split(line, of_rows);
    drop_empty_cells(cells, columns.size());
    return cells;
  };
  // A header with commas often stands above rows with blanks.
  char separator_of_rows = separator;
  if (first_row < content.size() && columns.size() > 1)
    if (const std::string &row = lines[content[first_row]];
        cells_of(row, separator).size() == 1 && cells_of(row, ' ').size() == columns.size())
      separator_of_rows = ' ';
  for (std::size_t i = first_row; i < content.size(); ++i)
  {
    const unsigned int line = static_cast<unsigned int>(content[i] + 1);
    rows.push_back({line, cells_of(lines[content[i]], separator_of_rows)});
    const std::size_t n_cells = rows.back().cells.size();
    if (n_cells != columns.size())
      throw InputError({file, line}, "",
                       "the row has " + std::to_string(n_cells) + " cells, the header " +
                           std::to_string(columns.size()),
                       "Give every row one number per column, with the header's separator and a "
                       "decimal point");
  }
}

std::string CsvTable::header_in_comment(const std::vector<std::string> &lines,
                                        const std::size_t first_row)
{
  std::size_t i = first_row;
  while (i > 0 && trim(lines[i - 1]).empty())
    --i;
  if (i == 0)
    return "";
  // A comment, since the first row is the first line that is none.
  std::string text = trim(lines[i - 1]);
  text.erase(0, text.find_first_not_of("# \t"));
  if (text.empty())
    return "";
  const std::vector<Column> named = parse_header(text, find_separator(text));
  const bool has_units =
      std::any_of(named.begin(), named.end(), [](const Column &column) { return column.has_unit; });
  if (!has_units || named.size() != cells_of_line(lines[first_row]).size())
    return "";
  header_line = static_cast<unsigned int>(i);
  return text;
}

void CsvTable::refuse_without_header(const std::vector<std::string> &lines,
                                     const std::vector<std::size_t> &content,
                                     const std::string &example) const
{
  const std::string &first = lines[content.front()];
  const bool counts = content.size() > 2 && count_rows(cells_of_line(first), content.size() - 1);
  const std::string &row = lines[content[counts ? 1 : 0]];
  const std::string header = header_for(example, cells_of_line(row).size(), find_separator(row));
  const std::string units = "' with the names and units of the columns";
  throw InputError({file, header_line}, "",
                   counts ? "the table has no header: this line counts the rows that follow"
                          : "the table has no header: this line has only numbers",
                   counts ? "Write '#' before this line, insert a line such as '" + header + units +
                                " below it, and keep all rows"
                          : "Insert a line such as '" + header + units +
                                " above this line, and keep this line");
}

std::vector<CsvTable::Column> CsvTable::parse_header(const std::string &line, const char separator)
{
  std::vector<Column> columns;
  std::vector<std::string> cells = split(line, separator);
  drop_empty_cells(cells, 1);
  for (std::string cell : cells)
  {
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

UnitScale CsvTable::unit_scale_of(const std::size_t number, const Dimension &dimension) const
{
  const Column &column = columns[number];
  if (!column.has_unit && dimension == Dimensions::none)
    return {};
  const std::string remedy =
      "Write the header as '" + (column.name.empty() ? "NAME" : column.name) + " [UNIT]'" +
      (dimension == Dimensions::none ? " or without a unit"
                                     : " with a unit of the dimension of " + dimension.unit() +
                                           " (" + usual_units(dimension) + ")");
  if (!column.has_unit)
    throw InputError(header(), column.name, "the column has no unit", remedy);
  try
  {
    Dimension found;
    const UnitScale scale = unit_scale(column.unit, found);
    if (found == dimension)
      return scale;
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
  const UnitScale scale = unit_scale_of(column, dimension);
  std::vector<double> values;
  values.reserve(rows.size());
  for (const Row &row : rows)
    values.push_back(
        scale.in_si(read_number({file, row.line}, columns[column].name, row.cells[column])));
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
    if (row == 1 && rows.size() > 2 && count_rows(rows.front().cells, rows.size() - 1))
      refuse(0, columns.size(), "the line counts the rows that follow, and is no row itself",
             "Write '#' before this line");
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
