#include <continua/base/nearly_equal.h>

#include <cmath>
#include <cstddef>

namespace Continua
{
bool nearly_equal(const double a, const double b)
{
  return !(std::abs(a - b) > 1e-12 * std::abs(a));
}

bool nearly_equal(const std::vector<double> &a, const std::vector<double> &b)
{
  if (a.size() != b.size())
    return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!nearly_equal(a[i], b[i]))
      return false;
  return true;
}
} // namespace Continua
