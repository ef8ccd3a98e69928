#include <continua/base/table_cells.h>
#include <continua/base/units.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
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
  return without_blanks_around(text);
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
} // namespace

std::string without_blanks_around(const std::string &text)
{
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos)
    return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string> split_into_cells(const std::string &line, const char separator)
{
  std::vector<std::string> cells(1);
  bool in_brackets = false, in_quotes = false;
  for (const char character : separator == ' ' ? without_blanks_around(line) : line)
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
    cell = bare_cell(without_blanks_around(cell));
  return cells;
}

char find_separator(const std::string &line)
{
  for (const char candidate : {';', ',', '\t'})
    if (split_into_cells(line, candidate).size() > 1)
      return candidate;
  return ' ';
}

void drop_empty_cells(std::vector<std::string> &cells, const std::size_t n)
{
  while (cells.size() > n && cells.back().empty())
    cells.pop_back();
}

std::vector<std::string> cells_of_line(const std::string &line)
{
  std::vector<std::string> cells = split_into_cells(line, find_separator(line));
  drop_empty_cells(cells, 1);
  return cells;
}

bool is_number(const std::string &cell, double &number)
{
  const std::string text = with_usual_exponent(cell);
  const char *const begin = text.data() + (!text.empty() && text[0] == '+' ? 1 : 0);
  const char *const end = text.data() + text.size();
  const auto result = std::from_chars(begin, end, number);
  return result.ec == std::errc() && result.ptr == end && std::isfinite(number);
}

bool are_numbers(const std::vector<std::string> &cells)
{
  double ignored = 0.;
  return std::all_of(cells.begin(), cells.end(),
                     [&](const std::string &cell) { return is_number(cell, ignored); });
}

bool has_decimal_comma(const std::string &cell)
{
  const std::size_t comma = cell.find(',');
  if (comma == std::string::npos || cell.find('.') != std::string::npos)
    return false;
  double ignored = 0.;
  std::string with_point = cell;
  with_point[comma] = '.';
  return is_number(with_point, ignored);
}

bool has_only_numbers(const std::string &line)
{
  return line.find_first_of("0123456789") != std::string::npos &&
         line.find_first_not_of("0123456789+-.,;eEdD\" \t") == std::string::npos;
}

bool is_gap(const std::string &cell)
{
  std::string small;
  for (const char letter : cell)
    small += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return small.empty() || small == "-" || small == "nan" || small == "na" || small == "n/a";
}

std::string unit_of_cell(const std::string &cell)
{
  const bool has_brackets = cell.size() > 2 && ((cell.front() == '[' && cell.back() == ']') ||
                                                (cell.front() == '(' && cell.back() == ')'));
  const std::string unit =
      has_brackets ? without_blanks_around(cell.substr(1, cell.size() - 2)) : cell;
  double number = 0.;
  if (unit.empty() || (!has_brackets && is_number(unit, number)))
    return "";
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

bool has_content(const std::string &line)
{
  const std::string content = without_blanks_around(line);
  return !content.empty() && content[0] != '#';
}

char separator_of_excel(const std::string &line)
{
  std::string text = without_blanks_around(line);
  if (text.size() > 1 && text.front() == '"' && text.back() == '"')
    text = text.substr(1, text.size() - 2);
  return text.size() == 5 && text.compare(0, 4, "sep=") == 0 ? text[4] : '\0';
}

bool count_rows(const std::vector<std::string> &cells, const std::size_t n_rows)
{
  return std::all_of(cells.begin(), cells.end(),
                     [](const std::string &cell) {
                       return !cell.empty() &&
                              cell.find_first_not_of("0123456789") == std::string::npos;
                     }) &&
         cells.front() == std::to_string(n_rows);
}

std::string header_for(const std::string &example, const std::size_t n_cells, const char separator)
{
  const std::vector<std::string> names = split_into_cells(example, ',');
  const std::string between = separator == ' '    ? "  "
                              : separator == '\t' ? "\t"
                                                  : std::string(1, separator) + " ";
  std::string header;
  for (std::size_t i = 0; i < std::max(names.size(), n_cells); ++i)
  {
    header += i > 0 ? between : "";
    const std::string cell =
        i < names.size() ? names[i] : "value " + std::to_string(i + 1) + " [1]";
    // Where blanks separate, only the one before a unit does not.
    const bool is_divided =
        separator == ' ' &&
        without_blanks_around(cell.substr(0, cell.find('['))).find(' ') != std::string::npos;
    header += is_divided ? '"' + cell + '"' : cell;
  }
  return header;
}

} // namespace Continua
