#include <continua/signal/jump.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
bool jumps_within(const std::function<double(double)> &function, double begin, double end)
{
  constexpr unsigned int n_halvings = 20;
  double value_begin = function(begin), value_end = function(end);
  // With the values an interval earlier and later: where a pulse comes to its end, or has just
  // begun, what is next to nothing would else be compared with itself.
  double largest =
      std::max({std::abs(value_begin), std::abs(value_end), std::abs(function(2. * begin - end)),
                std::abs(function(2. * end - begin))});
  for (unsigned int i = 0; i < n_halvings; ++i)
  {
    const double middle = 0.5 * (begin + end);
    const double value = function(middle);
    largest = std::max(largest, std::abs(value));
    if (std::abs(value - value_begin) >= std::abs(value_end - value))
    {
      end = middle;
      value_end = value;
    }
    else
    {
      begin = middle;
      value_begin = value;
    }
  }
  return std::abs(value_end - value_begin) > 1e-2 * largest;
}
} // namespace Continua
