#include <continua/base/text_table.h>

#include <continua/base/units.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Continua
{
std::vector<std::string> aligned_lines(const std::vector<std::vector<std::string>> &rows)
{
  std::vector<std::size_t> widths;
  for (const auto &row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      if (i == widths.size())
        widths.push_back(0);
      widths[i] = std::max(widths[i], row[i].size());
    }
  std::vector<std::string> lines;
  for (const auto &row : rows)
  {
    std::ostringstream text;
    for (std::size_t i = 0; i < row.size(); ++i)
      text << (i == 0 ? "" : "  ") << (i == 0 ? std::left : std::right)
           << std::setw(static_cast<int>(widths[i])) << row[i];
    std::string line = text.str();
    line.erase(line.find_last_not_of(' ') + 1);
    lines.push_back(line);
  }
  return lines;
}

std::string number_text(const double value, const int n_digits)
{
  std::ostringstream text;
  text << std::setprecision(n_digits) << value;
  return text.str();
}

std::string with_unit(const std::string &name, const std::string &unit)
{
  return name + (unit.empty() || unit == "1" ? "" : " [" + unit + "]");
}

std::string csv_cell(const std::string &text)
{
  std::string result = "\"";
  for (const char letter : text)
    result += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return result + '"';
}

std::string csv_cell(const double value)
{
  return std::isfinite(value) ? shortest_number(value) : "";
}
} // namespace Continua
