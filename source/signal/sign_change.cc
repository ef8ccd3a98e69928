#include <continua/signal/sign_change.h>

#include <continua/base/undefined.h>

#include <algorithm>
#include <cstddef>

namespace Continua
{
double find_sign_change(std::vector<std::pair<double, double>> points, const unsigned int number)
{
  std::sort(points.begin(), points.end());
  points.erase(std::remove_if(points.begin(), points.end(),
                              [](const auto &point) { return point.second == 0.; }),
               points.end());
  unsigned int n_found = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const auto [before, value_before] = points[i - 1];
    const auto [after, value_after] = points[i];
    if ((value_before > 0.) == (value_after > 0.) || n_found++ < number)
      continue;
    return before + (after - before) * value_before / (value_before - value_after);
  }
  return undefined;
}
} // namespace Continua
