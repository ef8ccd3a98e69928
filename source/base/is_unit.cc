#include <continua/base/is_unit.h>

#include <continua/base/units.h>

#include <stdexcept>

namespace Continua
{
bool is_unit(const std::string &text)
{
  try
  {
    Dimension dimension;
    unit_factor(text, dimension);
    return true;
  }
  catch (const std::invalid_argument &)
  {
    return false;
  }
}
} // namespace Continua
