#include <continua/mesh/tube_cross_section.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Continua
{
using dealii::Point;

namespace
{
constexpr double half_side = TubeCrossSection::half_side;
constexpr double eighth_turn = 0.25 * dealii::numbers::PI;

// In the first eighth of the turn, 0 <= z <= y, with 0 <= w <= 1 from the y axis to the diagonal.

/// Where the line w meets the circle; exact on the axis and on the diagonal.
Point<2> on_circle(const double w)
{
  return w == 1. ? Point<2>(std::sqrt(0.5), std::sqrt(0.5))
                 : Point<2>(std::cos(eighth_turn * w), std::sin(eighth_turn * w));
}

Point<2> on_core(const double w)
{
  return {half_side, half_side * w};
}

Point<2> point_in_eighth(const double rho, const double w)
{
  return rho > 1. ? Point<2>(rho * on_circle(w))
                  : Point<2>((1. - rho) * on_core(w) + rho * on_circle(w));
}

/// The line w through a point inside the circle, by Newton's iteration.
double line_through(const Point<2> &p)
{
  double w = std::atan2(p[1], p[0]) / eighth_turn;
  for (unsigned int iteration = 0; iteration < 30; ++iteration)
  {
    const Point<2> core = on_core(w);
    const Point<2> circle = {std::cos(eighth_turn * w), std::sin(eighth_turn * w)};
    const double dy = circle[0] - core[0];
    const double dz = circle[1] - core[1];
    // The area between the line and the point is zero.
    const double residual = (p[0] - core[0]) * dz - (p[1] - core[1]) * dy;
    const double derivative = (p[0] - core[0]) * (eighth_turn * circle[0] - half_side) +
                              half_side * dy + (p[1] - core[1]) * eighth_turn * circle[1];
    const double change = residual / derivative;
    w -= change;
    if (std::abs(change) < 1e-15)
      break;
  }
  return w;
}

/// (rho, w) of a point of the eighth.
Point<2> place_in_eighth(const Point<2> &p)
{
  const double radius = std::hypot(p[0], p[1]);
  const bool on_axis = p[1] == 0.;
  const bool on_diagonal = p[0] == p[1];
  if (radius >= 1.)
    return {radius, on_axis ? 0. : on_diagonal ? 1. : std::atan2(p[1], p[0]) / eighth_turn};
  const double w = on_axis ? 0. : on_diagonal ? 1. : line_through(p);
  const auto direction = on_circle(w) - on_core(w);
  return {(p - on_core(w)) * direction / direction.norm_square(), w};
}
} // namespace

Point<2> TubeCrossSection::point(const double rho, const double u)
{
  double turned = std::fmod(u, full_turn);
  if (turned < 0.)
    turned += full_turn;
  // By reflection into the first quarter, and there into its first eighth.
  const unsigned int quarter = std::min(3, static_cast<int>(turned / 2.));
  double v = turned - 2. * quarter;
  if (quarter % 2 == 1)
    v = 2. - v;
  Point<2> p = point_in_eighth(rho, v > 1. ? 2. - v : v);
  if (v > 1.)
    std::swap(p[0], p[1]);
  if (quarter == 1 || quarter == 2)
    p[0] = -p[0];
  if (quarter >= 2)
    p[1] = -p[1];
  return p;
}

Point<2> TubeCrossSection::place(const Point<2> &point)
{
  Point<2> p(std::abs(point[0]), std::abs(point[1]));
  const bool is_swapped = p[1] > p[0];
  if (is_swapped)
    std::swap(p[0], p[1]);
  Point<2> result = place_in_eighth(p);
  const double v = is_swapped ? 2. - result[1] : result[1];
  if (point[1] >= 0.)
    result[1] = point[0] >= 0. ? v : 4. - v;
  else
    result[1] = point[0] < 0. ? 4. + v : full_turn - v;
  return result;
}

TubeCrossSection::TubeCrossSection(const std::vector<double> &rings,
                                   const unsigned int n_side_cells,
                                   const Sector sector)
{
  // Cells that meet compute their common vertices alike, to the last bit.
  std::map<std::array<double, 2>, unsigned int> numbers;
  const auto number = [this, &numbers](const Point<2> &p)
  {
    // Without a negative zero.
    const auto found = numbers.emplace(std::array<double, 2>{{p[0] + 0., p[1] + 0.}},
                                       static_cast<unsigned int>(all_vertices.size()));
    if (found.second)
      all_vertices.emplace_back(p[0] + 0., p[1] + 0.);
    return found.first->second;
  };
  // The edges of all cells point away from the axes, so that those of neighbours agree.
  const auto add =
      [&](const std::array<Point<2>, 4> &corners, const bool is_core, const unsigned int ring)
  {
    std::array<Point<2>, 4> turned = corners;
    for (unsigned int quarter = 0; quarter < static_cast<unsigned int>(sector); ++quarter)
    {
      Cell cell{{}, is_core, ring};
      for (unsigned int v = 0; v < 4; ++v)
      {
        cell.vertices[v] = number(turned[v]);
        turned[v] = Point<2>(-turned[v][1], turned[v][0]);
      }
      all_cells.push_back(cell);
    }
  };
  const auto side = [n_side_cells](const unsigned int i)
  { return static_cast<double>(i) / n_side_cells; };
  const auto core = [&side](const unsigned int i, const unsigned int j)
  { return Point<2>(half_side * side(i), half_side * side(j)); };
  const auto mirrored = [](const Point<2> &p) { return Point<2>(p[1], p[0]); };

  for (unsigned int j = 0; j < n_side_cells; ++j)
    for (unsigned int i = 0; i < n_side_cells; ++i)
      add({{core(i, j), core(i + 1, j), core(i, j + 1), core(i + 1, j + 1)}}, true, 0);
  for (unsigned int ring = 0; ring + 1 < rings.size(); ++ring)
    for (unsigned int j = 0; j < n_side_cells; ++j)
    {
      const std::array<Point<2>, 4> p = {{point_in_eighth(rings[ring], side(j)),
                                          point_in_eighth(rings[ring + 1], side(j)),
                                          point_in_eighth(rings[ring], side(j + 1)),
                                          point_in_eighth(rings[ring + 1], side(j + 1))}};
      add(p, false, ring);
      add({{mirrored(p[0]), mirrored(p[2]), mirrored(p[1]), mirrored(p[3])}}, false, ring);
    }
}
} // namespace Continua
