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
  const double earlier = function(2. * begin - end), later = function(2. * end - begin);
  // The change counts, not the level: a constant that is added to a load adds a constant answer.
  double lowest = std::min({value_begin, value_end, earlier, later}),
         highest = std::max({value_begin, value_end, earlier, later});
  for (unsigned int i = 0; i < n_halvings; ++i)
  {
    const double middle = 0.5 * (begin + end);
    const double value = function(middle);
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
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
  const double round_off = 1e-12 * std::max(std::abs(lowest), std::abs(highest));
  return std::abs(value_end - value_begin) > std::max(1e-2 * (highest - lowest), round_off);
}
} // namespace Continua
