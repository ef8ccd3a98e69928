#include <continua/mesh/cylinder_sector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Continua
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/// `vector` turned counter-clockwise by so many quarters, without round-off.
Tensor<1, 2> turned(const Tensor<1, 2> &vector, const unsigned int quarters)
{
  Tensor<1, 2> result = vector;
  for (unsigned int i = 0; i < quarters % 4; ++i)
    result = Tensor<1, 2>({-result[1], result[0]});
  return result;
}

double cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

double between(const std::array<double, 2> &ends, const double v)
{
  return ends[0] * (1. - v) + ends[1] * v;
}

/// The ends of the line v, with the centre in the origin and the side towards x.
struct Line
{
  Tensor<1, 2> on_circle;
  Tensor<1, 2> on_side;
};

Line line(const CylinderSector &sector, const double v)
{
  const double side = between(sector.sides, v);
  if (sector.is_beam)
    return {
        Tensor<1, 2>({std::sqrt(std::max(0., sector.radius * sector.radius - side * side)), side}),
        Tensor<1, 2>({sector.half_side, side})};
  const double angle = between(sector.angles, v);
  return {Tensor<1, 2>({sector.radius * std::cos(angle), sector.radius * std::sin(angle)}),
          Tensor<1, 2>({sector.half_side, side})};
}

/// The line v of a sector without a beam that `vector` is on.
double line_through(const CylinderSector &sector, const Tensor<1, 2> &vector)
{
  const double arc = sector.angles[1] - sector.angles[0];
  const double side = sector.sides[1] - sector.sides[0];
  double lower = -0.5, upper = 1.5, v = 0.5;
  // Newton's method, kept between two bounds: on which side of the line the vector is tells which
  // of them moves. It takes five steps or so; halving alone would take 54.
  for (unsigned int step = 0; step < 100; ++step)
  {
    const auto [on_circle, on_side] = line(sector, v);
    const Tensor<1, 2> along = on_side - on_circle, from_circle = vector - on_circle;
    const double distance = cross(along, from_circle);
    (distance > 0. ? lower : upper) = v;
    // The derivatives by v of the ends.
    const Tensor<1, 2> circle_slope({-on_circle[1] * arc, on_circle[0] * arc});
    const Tensor<1, 2> side_slope({0., side});
    const double slope = cross(side_slope - circle_slope, from_circle) - cross(along, circle_slope);
    const double next = v - distance / slope;
    if (std::abs(next - v) <= std::numeric_limits<double>::epsilon())
      break;
    v = next > lower && next < upper ? next : 0.5 * (lower + upper);
  }
  return v;
}
} // namespace

Point<2> CylinderSector::point(const double s, const double v) const
{
  const auto [on_circle, on_side] = line(*this, v);
  return centre + turned((1. - s) * on_circle + s * on_side, quarter);
}

Point<2> CylinderSector::place(const Point<2> &point) const
{
  const Tensor<1, 2> vector = turned(point - centre, 4 - quarter);
  const double v =
      is_beam ? (vector[1] - sides[0]) / (sides[1] - sides[0]) : line_through(*this, vector);
  const auto [on_circle, on_side] = line(*this, v);
  const Tensor<1, 2> along = on_side - on_circle;
  return {(vector - on_circle) * along / along.norm_square(), v};
}
} // namespace Continua
