#include <continua/network/limited_slopes.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
/// How alike three second differences are [1]: 1 in a smooth wave, 0 at a jump.
double likeness(const double before, const double of_cell, const double behind)
{
  const double a = before * of_cell, b = of_cell * behind;
  if (!(a > 0. && b > 0.))
    return 0.;
  const double sizes[] = {std::abs(before), std::abs(of_cell), std::abs(behind)};
  const double largest = std::max(std::max(sizes[0], sizes[1]), sizes[2]),
               smallest = std::min(std::min(sizes[0], sizes[1]), sizes[2]);
  return std::min(std::max(4. * smallest / largest - 1., 0.), 1.);
}

} // namespace

void set_limited_differences(const std::vector<double> &values, std::vector<double> &differences)
{
  const std::size_t n = values.size();
  if (n < 3)
  {
    differences.assign(n, n == 2 ? values[1] - values[0] : 0.);
    return;
  }
  const auto first = [&](const std::size_t i) { return values[i + 1] - values[i]; };
  double before = first(0), behind = first(1), last = behind - before, second = last;
  differences[0] = before * behind > 0. ? before : 0.;
  for (std::size_t i = 1; i + 1 < n; ++i)
  {
    const double further = i + 2 < n ? first(i + 1) : behind + second, next = further - behind,
                 product = before * behind, mean = 0.5 * (before + behind),
                 limited = product > 0. ? product / mean : 0., share = likeness(last, second, next);
    differences[i] = limited + share * (mean - limited);
    before = behind;
    behind = further;
    last = second;
    second = next;
  }
  differences[n - 1] = before * (before - last) > 0. ? before : 0.;
}

} // namespace Continua
