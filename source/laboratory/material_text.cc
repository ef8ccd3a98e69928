#include <continua/laboratory/material_text.h>

#include <continua/base/six_digits.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
std::string material_text(const BarLawFit &fit, const double density)
{
  BarLaw::Entries entries = fit.law->entries(fit.result.estimates);
  entries.insert(entries.begin() + 1, {"Density", six_digits(density) + " kg/m^3"});
  std::size_t width = 0;
  for (const auto &[key, value] : entries)
    width = std::max(width, key.size());
  std::ostringstream text;
  text << "# " << fit.law->description()
       << ", as Analysis = material fit has found it. Standard errors:\n";
  for (std::size_t i = 0; i < fit.parameters.size(); ++i)
  {
    text << "#   " << fit.parameters[i].name << ": ";
    const double error = fit.result.standard_errors[i];
    if (std::isfinite(error))
      text << six_digits(error)
           << (fit.parameters[i].unit == "1" ? "" : " " + fit.parameters[i].unit);
    else
      text << "none, it is at its bound or the tables do not show it";
    text << "\n";
  }
  text << "set Analysis = material\nsubsection Materials\n  subsection wall\n";
  for (const auto &[key, value] : entries)
    text << "    set " << key << std::string(width - key.size(), ' ') << " = " << value << "\n";
  text << "  end\nend\n";
  return text.str();
}
} // namespace Continua
