#include <continua/base/nearly_equal.h>

#include <cmath>
#include <cstddef>

namespace Continua
{
bool nearly_equal(const std::vector<double> &a, const std::vector<double> &b)
{
  if (a.size() != b.size())
    return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::abs(a[i] - b[i]) > 1e-12 * std::abs(a[i]))
      return false;
  return true;
}
} // namespace Continua
