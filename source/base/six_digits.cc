#include <continua/base/six_digits.h>

#include <sstream>

namespace Continua
{
std::string six_digits(const double value)
{
  std::ostringstream text;
  text.precision(6);
  text << value;
  return text.str();
}
} // namespace Continua
