#include <continua/base/required_entry.h>

#include <limits>

namespace Continua
{
double required_entry(ParameterSection &section,
                      const std::string &key,
                      const Dimension &dimension,
                      const std::string &text,
                      const Range &range)
{
  double value = std::numeric_limits<double>::quiet_NaN();
  section.add(key, value, dimension, text + " Required.", range);
  section.require(key);
  return value;
}
} // namespace Continua
