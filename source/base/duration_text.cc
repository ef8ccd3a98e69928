#include <continua/base/duration_text.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace Continua
{
std::string duration_text(const double seconds)
{
  const long n_seconds = std::lround(seconds);
  std::ostringstream text;
  text << std::setfill('0');
  if (n_seconds >= 3600)
    text << n_seconds / 3600 << " h " << std::setw(2) << n_seconds % 3600 / 60 << " min";
  else if (n_seconds >= 60)
    text << n_seconds / 60 << " min " << std::setw(2) << n_seconds % 60 << " s";
  else
    text << n_seconds << " s";
  return text.str();
}
} // namespace Continua
