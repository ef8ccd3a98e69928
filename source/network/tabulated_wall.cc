#include <continua/network/tabulated_wall.h>

#include <continua/network/flow_law.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Continua
{
namespace
{
/// Of the area over that without load [1].
constexpr double smallest = 1. / 3., largest = 3.;
constexpr unsigned int n_intervals = 160, place_of_rest = 40; // the area 1 is a point of the table
constexpr double spacing = (largest - smallest) / n_intervals;
} // namespace

TabulatedWall::TabulatedWall(const double area,
                             const std::function<double(double)> &pressure_of,
                             const double shift)
    : area_without_load(area), shift(shift)
{
  std::vector<double> all(n_intervals + 1, std::numeric_limits<double>::quiet_NaN());
  const auto set = [&](const unsigned int i)
  {
    all[i] = pressure_of(std::sqrt(area * (smallest + i * spacing) / FlowLaw::pi));
    return all[i];
  };
  set(place_of_rest);
  // As far as the pressure rises, to both sides of the state without load.
  unsigned int last = place_of_rest, first = place_of_rest;
  while (last < n_intervals && set(last + 1) > all[last])
    ++last;
  while (first > 0 && set(first - 1) < all[first])
    --first;
  constexpr unsigned int fewest = 3; // for the slopes
  if (last < place_of_rest + fewest || first + fewest > place_of_rest)
    throw std::domain_error("gives way to any pressure");
  auto made = std::make_shared<Table>();
  made->first = smallest + first * spacing;
  made->pressures.assign(all.begin() + first, all.begin() + last + 1);
  const std::vector<double> &p = made->pressures;
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const bool inside = i >= 2 && i + 2 < n;
    const double slope =
        inside  ? (8. * (p[i + 1] - p[i - 1]) - (p[i + 2] - p[i - 2])) / (12. * spacing)
        : i < 2 ? (-25. * p[i] + 48. * p[i + 1] - 36. * p[i + 2] + 16. * p[i + 3] - 3. * p[i + 4]) /
                      (12. * spacing)
                : (25. * p[i] - 48. * p[i - 1] + 36. * p[i - 2] - 16. * p[i - 3] + 3. * p[i - 4]) /
                      (12. * spacing);
    made->slopes.push_back(std::fmax(slope, 0.));
  }
  table = made;
}

TabulatedWall::TabulatedWall(const double area,
                             const TabulatedWall &first,
                             const TabulatedWall &second,
                             const double share)
    : area_without_load(area), shift(first.shift)
{
  // Where both have values.
  const Table &a = *first.table, &b = *second.table;
  auto made = std::make_shared<Table>();
  made->first = std::max(a.first, b.first);
  const auto begin_of = [&made](const Table &of)
  { return static_cast<std::size_t>(std::lround((made->first - of.first) / spacing)); };
  const std::size_t of_a = begin_of(a), of_b = begin_of(b),
                    n = std::min(a.pressures.size() - of_a, b.pressures.size() - of_b);
  for (std::size_t i = 0; i < n; ++i)
  {
    made->pressures.push_back((1. - share) * a.pressures[of_a + i] + share * b.pressures[of_b + i]);
    made->slopes.push_back((1. - share) * a.slopes[of_a + i] + share * b.slopes[of_b + i]);
  }
  table = made;
}

PressureAndStiffness TabulatedWall::in_interval(const std::size_t i, const double t) const
{
  const double left = table->pressures[i], difference = table->pressures[i + 1] - left,
               first = spacing * table->slopes[i], second = spacing * table->slopes[i + 1],
               square = 3. * difference - 2. * first - second,
               cube = first + second - 2. * difference;
  return {left + t * (first + t * (square + t * cube)),
          (first + t * (2. * square + t * 3. * cube)) / spacing};
}

PressureAndStiffness TabulatedWall::both(const double area) const
{
  const double place = (area / area_without_load - table->first) / spacing;
  const std::size_t last = table->pressures.size() - 1;
  if (!(place >= 0. && place <= static_cast<double>(last)))
    return {std::nan(""), std::nan("")};
  const std::size_t i = std::min(static_cast<std::size_t>(place), last - 1);
  const PressureAndStiffness values = in_interval(i, place - static_cast<double>(i));
  return {values.pressure + shift, values.stiffness / area_without_load};
}

double TabulatedWall::area(const double wanted, const double /*start*/) const
{
  const std::vector<double> &p = table->pressures;
  const double value = wanted - shift;
  if (!(value >= p.front() && value <= p.back()))
    return std::nan("");
  const std::size_t behind = std::upper_bound(p.begin(), p.end(), value) - p.begin(),
                    i = std::min(behind, p.size() - 1) - 1;
  // Newton's method between limits that close in.
  double low = 0., high = 1., t = (value - p[i]) / (p[i + 1] - p[i]);
  constexpr unsigned int most_iterations = 60;
  constexpr double tolerance = 1e-15;
  for (unsigned int iteration = 0; iteration < most_iterations; ++iteration)
  {
    const PressureAndStiffness there = in_interval(i, t);
    (there.pressure < value ? low : high) = t;
    double next = t + (value - there.pressure) / (there.stiffness * spacing);
    if (!(next >= low && next <= high))
      next = 0.5 * (low + high);
    const double change = std::abs(next - t);
    t = next;
    if (change < tolerance)
      break;
  }
  return area_without_load * (table->first + (static_cast<double>(i) + t) * spacing);
}
} // namespace Continua
