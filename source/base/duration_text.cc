#include <continua/base/duration_text.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace Continua
{
std::string duration_text(const double seconds)
{
  const long whole = std::lround(seconds);
  std::ostringstream text;
  text << std::setfill('0');
  if (whole >= 3600)
    text << whole / 3600 << " h " << std::setw(2) << whole % 3600 / 60 << " min";
  else if (whole >= 60)
    text << whole / 60 << " min " << std::setw(2) << whole % 60 << " s";
  else
    text << whole << " s";
  return text.str();
}
} // namespace Continua
