#include <continua/signal/up_crossings.h>

#include <continua/base/undefined.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace Continua
{
std::vector<double> find_up_crossings(const std::vector<double> &times,
                                      const std::vector<double> &values,
                                      const double level,
                                      const double margin)
{
  std::vector<double> crossings;
  bool below = false;
  double first = undefined;
  double last = undefined;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const double value = values[i] - level;
    if (below && i > 0 && value >= 0. && values[i - 1] < level)
    {
      const double previous = values[i - 1] - level;
      last = times[i - 1] - previous * (times[i] - times[i - 1]) / (value - previous);
      if (std::isnan(first))
        first = last;
    }
    if (value < -margin)
    {
      // A way up that did not reach the margin was none.
      below = true;
      first = undefined;
    }
    else if (value > margin && below)
    {
      crossings.push_back(0.5 * (first + last));
      below = false;
      first = undefined;
    }
  }
  return crossings;
}

SignalAverages average_signal(const std::vector<double> &times,
                              const std::vector<double> &values,
                              const double start,
                              const double end)
{
  SignalAverages sums = {0., 0.};
  for (std::size_t i = 1; i < times.size(); ++i)
  {
    const double left = std::max(start, times[i - 1]);
    const double right = std::min(end, times[i]);
    if (right <= left)
      continue;
    const double slope = (values[i] - values[i - 1]) / (times[i] - times[i - 1]);
    const double a = values[i - 1] + slope * (left - times[i - 1]);
    const double b = values[i] - slope * (times[i] - right);
    sums.mean += 0.5 * (right - left) * (a + b);
    sums.mean_square += 0.5 * (right - left) * (a * a + b * b);
  }
  return {sums.mean / (end - start), sums.mean_square / (end - start)};
}
} // namespace Continua
