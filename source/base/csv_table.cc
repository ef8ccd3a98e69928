#include <continua/base/csv_table.h>
#include <continua/base/input_file.h>
#include <continua/base/table_cells.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <set>
#include <stdexcept>

namespace Continua
{
namespace
{
const char *const points_for_commas =
    "Exchange the commas for points, as 'tr , . < FILE > NEW' does";

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
  return unit_of_cell(cell.substr(open));
}

double read_number(const Origin &origin, const std::string &column, const std::string &cell)
{
  if (is_gap(cell))
    throw InputError(origin, column, "the value is missing", "Fill it in, or remove the line");
  if (has_decimal_comma(cell))
    throw InputError(origin, column, "'" + cell + "' has a decimal comma", points_for_commas);
  double number = 0.;
  if (!is_number(cell, number))
    throw InputError(origin, column,
                     (is_plain_name(cell) ? "'" + cell + "'" : "the cell") + " is not a number",
                     "Write a finite number with a decimal point and no unit, such as -1.5e-3");
  return number;
}

/// Throws where the second line, which is the first row if there is a header, has numbers in
/// brackets.
void refuse_brackets(const std::string &file, const std::size_t place, std::string line)
{
  const std::size_t size = line.size();
  line.erase(std::remove_if(line.begin(), line.end(),
                            [](const char letter) { return letter == '(' || letter == ')'; }),
             line.end());
  if (line.size() < size && has_only_numbers(line))
    throw InputError({file, static_cast<unsigned int>(place + 1)}, "", "the row stands in brackets",
                     "Remove the brackets, as \"tr -d '()' < FILE > NEW\" does");
}
} // namespace

CsvTable::CsvTable(const std::string &file, const std::string &example, const std::string &advice)
    : file(file), advice(advice)
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
  if (content.size() > 1)
    refuse_brackets(file, content[1], lines[content[1]]);
  if (first_row == 1 && content.size() > 1 && !has_units(columns))
  {
    const bool units_follow = take_units(cells_of_line(lines[content[1]]));
    if (units_follow)
      first_row = 2;
    else
      refuse_what_is_no_header(lines, content, example);
  }

  const auto cells_of = [&](const std::string &line, const char of_rows)
  {
    std::vector<std::string> cells = split_into_cells(line, of_rows);
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
  while (i > 0 && without_blanks_around(lines[i - 1]).empty())
    --i;
  if (i == 0)
    return "";
  // A comment, since the first row is the first line that is none.
  std::string text = without_blanks_around(lines[i - 1]);
  text.erase(0, text.find_first_not_of("# \t"));
  if (text.empty())
    return "";
  const std::vector<Column> named = parse_header(text, find_separator(text));
  if (!has_units(named) || named.size() != cells_of_line(lines[first_row]).size())
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
  const std::string line = "insert a line such as '" + header +
                           "' with the names and units of the columns" + units_of(example);
  throw InputError({file, header_line}, "",
                   counts ? "the table has no header: this line counts the rows that follow"
                          : "the table has no header: this line has only numbers",
                   (counts ? "Write '#' before this line, " + line + " below it, and keep all rows"
                           : "I" + line.substr(1) + " above this line, and keep this line") +
                       advice);
}

void CsvTable::refuse_what_is_no_header(const std::vector<std::string> &lines,
                                        const std::vector<std::size_t> &content,
                                        const std::string &example) const
{
  const std::string &first = lines[content.front()];
  if (has_only_numbers(first))
    throw InputError({file, header_line}, "",
                     "the table has no header, and its numbers have decimal commas",
                     std::string(points_for_commas) + ", and insert a first line such as '" +
                         header_for(example, 0, ',') + "' with the names and units of the columns" +
                         units_of(example) + advice);
  // Lines of text before the first row, of which none is a header with units.
  const auto begins_with_text = [&](const std::size_t i)
  {
    const std::vector<std::string> cells = cells_of_line(lines[i]);
    double ignored = 0.;
    return !is_gap(cells.front()) && !is_number(cells.front(), ignored);
  };
  const auto row = std::find_if_not(content.begin(), content.end(), begins_with_text);
  if (row == content.end() || row - content.begin() < 2)
    return;
  const std::string &cells = lines[*row];
  throw InputError({file, header_line}, "",
                   "the " + std::to_string(row - content.begin()) +
                       " lines before the first row of numbers (line " + std::to_string(*row + 1) +
                       ") are no header with units",
                   "Write '#' before each of them, and insert a line such as '" +
                       header_for(example, cells_of_line(cells).size(), find_separator(cells)) +
                       "' with the names and units of the columns" + units_of(example) +
                       " below them" + advice);
}

bool CsvTable::has_units(const std::vector<Column> &columns)
{
  return std::any_of(columns.begin(), columns.end(),
                     [](const Column &column) { return column.has_unit; });
}

bool CsvTable::take_units(const std::vector<std::string> &cells)
{
  std::vector<std::string> units;
  for (const std::string &cell : cells)
    units.push_back(unit_of_cell(cell));
  if (units.size() != columns.size() || std::count(units.begin(), units.end(), "") > 0)
    return false;
  for (std::size_t i = 0; i < units.size(); ++i)
  {
    columns[i].unit = units[i];
    columns[i].has_unit = true;
  }
  return true;
}

std::string CsvTable::units_of(const std::string &example)
{
  std::string text;
  std::set<std::string> lists;
  for (const Column &column : parse_header(example, ','))
  {
    Dimension dimension;
    unit_factor(column.unit, dimension);
    const std::string units = usual_units(dimension);
    if (!(dimension == Dimensions::none) && lists.insert(units).second)
      text += (text.empty() ? " (" : "; ") + units;
  }
  return text.empty() ? text : text + ")";
}

std::vector<CsvTable::Column> CsvTable::parse_header(const std::string &line, const char separator)
{
  std::vector<Column> columns;
  std::vector<std::string> cells = split_into_cells(line, separator);
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
    column.name = without_blanks_around(cell.substr(0, open));
    if (open != std::string::npos && cell.back() == ']')
    {
      column.unit = without_blanks_around(cell.substr(open + 1, cell.size() - open - 2));
      column.has_unit = true;
    }
    std::size_t round_open = 0;
    if (const std::string unit = unit_in_round_brackets(cell, round_open);
        open == std::string::npos && !unit.empty())
    {
      column.name = without_blanks_around(cell.substr(0, round_open));
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
                                           " (" + usual_units(dimension) + ")") +
      (number > 0 ? advice : "");
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

std::vector<std::string> CsvTable::texts(const std::size_t column) const
{
  std::vector<std::string> texts;
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    texts.push_back(rows[row].cells[column]);
    if (texts.back().empty())
      refuse(row, column, "the cell is empty", "Write a name there");
  }
  return texts;
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
