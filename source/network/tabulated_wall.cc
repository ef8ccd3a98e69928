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
/// Of the logarithm of the area over that of the mesh [1].
constexpr double spacing = 1. / 80.;
/// In the logarithm of 3.
constexpr unsigned int n_of_three = 88;
/// The area of the mesh is a point of the table. A ring that was opened is much smaller when it is
/// closed: down to 1/81 of it.
constexpr unsigned int place_of_mesh = 4 * n_of_three, n_intervals = place_of_mesh + n_of_three;

double place_of(const unsigned int i)
{
  return spacing * (static_cast<double>(i) - static_cast<double>(place_of_mesh));
}
} // namespace

TabulatedWall::TabulatedWall(const double area,
                             const std::function<double(double)> &pressure_of,
                             const double shift)
    : mesh_area(area), shift(shift)
{
  std::vector<double> all(n_intervals + 1, std::numeric_limits<double>::quiet_NaN());
  const auto set = [&](const unsigned int i)
  {
    all[i] = pressure_of(std::sqrt(area * std::exp(place_of(i)) / FlowLaw::pi));
    return all[i];
  };
  set(place_of_mesh);
  // As far as the pressure rises, to both sides of the state of the mesh, and to a third of the
  // area at which the wall has no pressure.
  unsigned int last = place_of_mesh, first = place_of_mesh, n_without_pressure = 0;
  while (last < n_intervals && set(last + 1) > all[last])
    ++last;
  while (first > 0 && n_without_pressure < n_of_three && set(first - 1) < all[first])
  {
    --first;
    if (all[first] <= 0.)
      ++n_without_pressure;
  }
  constexpr unsigned int fewest = 3; // for the slopes
  if (last < place_of_mesh + fewest || first + fewest > place_of_mesh)
    throw std::domain_error("gives way to any pressure");
  auto made = std::make_shared<Table>();
  made->first = place_of(first);
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
    : mesh_area(area), shift(first.shift)
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
  const double place = (std::log(area / mesh_area) - table->first) / spacing;
  const std::size_t last = table->pressures.size() - 1;
  if (!(place >= 0. && place <= static_cast<double>(last)))
    return {std::nan(""), std::nan("")};
  const std::size_t i = std::min(static_cast<std::size_t>(place), last - 1);
  const PressureAndStiffness values = in_interval(i, place - static_cast<double>(i));
  return {values.pressure + shift, values.stiffness / area};
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
  return mesh_area * std::exp(table->first + (static_cast<double>(i) + t) * spacing);
}
} // namespace Continua
