#include <continua/case/before_the_run/preflight_entry.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace Continua
{
std::string quantity_text(const double value, const std::string &unit)
{
  static const std::vector<std::pair<double, std::string>> prefixes = {
      {1., ""}, {1e-3, "m"}, {1e-6, "u"}};
  double shown = value;
  std::string shown_unit = unit;
  if ((unit == "m" && value < 0.1) || (unit == "s" && value < 1.))
    for (const auto &[factor, prefix] : prefixes)
      if (value != 0. && std::isfinite(value))
      {
        shown = value / factor;
        shown_unit = prefix + unit;
        if (shown >= 1. || factor == 1e-6)
          break;
      }
  std::ostringstream text;
  text.precision(4);
  if (std::isinf(shown))
    text << "infinite";
  else
    text << shown << (unit == "1" ? "" : " " + shown_unit);
  return text.str();
}

std::vector<std::string> preflight_text(const std::string &title,
                                        const std::vector<PreflightEntry> &entries)
{
  std::size_t name_width = 0, value_width = 0;
  for (const PreflightEntry &entry : entries)
  {
    name_width = std::max(name_width, entry.name.size());
    value_width = std::max(value_width, quantity_text(entry.value, entry.unit).size());
  }
  std::vector<std::string> lines = {title};
  for (const PreflightEntry &entry : entries)
  {
    std::string line = "  " + entry.name + std::string(name_width + 2 - entry.name.size(), ' ') +
                       quantity_text(entry.value, entry.unit);
    if (!entry.remark.empty())
      line += std::string(name_width + value_width + 6 - line.size(), ' ') + entry.remark;
    lines.push_back(line);
  }
  return lines;
}
} // namespace Continua
