#include <continua/signal/beats.h>

#include <algorithm>

namespace Continua
{
namespace
{
constexpr double low = 0.3, high = 0.7, flat = 0.01;
}

Beats find_beats(const std::vector<double> &values)
{
  Beats beats;
  beats.second_begins = values.size();
  if (values.empty())
    return beats;
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  const double range = *largest - *least;
  if (!(range > 0.))
    return beats;
  bool is_low = true;
  std::size_t last_fall = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double part = (values[i] - *least) / range;
    if (is_low && part > high)
    {
      is_low = false;
      if (++beats.number == 2)
      {
        const auto begin = values.begin() + last_fall, end = values.begin() + i;
        const double threshold = *std::min_element(begin, end) + flat * range;
        beats.second_begins = i;
        while (values[beats.second_begins] > threshold)
          --beats.second_begins;
      }
    }
    else if (!is_low && part < low)
    {
      is_low = true;
      last_fall = i;
    }
  }
  return beats;
}
} // namespace Continua
