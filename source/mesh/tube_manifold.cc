#include <continua/mesh/tube_cross_section.h>
#include <continua/mesh/tube_manifold.h>

#include <cmath>

namespace Continua
{
using dealii::Point;

namespace
{
/// The inverse of TubeManifold::radius.
double scaled_radius(const TubeLaw &law, const double x, const double radius)
{
  const double inner_radius = 0.5 * law.inner_diameter(x);
  // A rigid tube has nothing beyond its inner radius but round-off.
  return radius <= inner_radius || law.is_rigid()
             ? radius / inner_radius
             : 1. + (radius - inner_radius) / law.wall_thickness(x);
}

/// Of a tube along the x axis, the point at that place of the same tube along the centreline.
Point<3> bent(const Centreline &centreline, const Point<3> &point)
{
  const Centreline::Frame frame = centreline.frame(point[0]);
  return frame.point + point[1] * frame.normal + point[2] * frame.binormal;
}

/// The inverse.
Point<3> straightened(const Centreline &centreline, const Point<3> &point)
{
  const double position = centreline.nearest(point);
  const Centreline::Frame frame = centreline.frame(position);
  const auto distance = point - frame.point;
  return {position, distance * frame.normal, distance * frame.binormal};
}

/// Only the rings of a whole section go round.
template <int dim>
dealii::Tensor<1, dim> periodicity(const bool rings)
{
  dealii::Tensor<1, dim> period;
  if (dim == 3 && rings)
    period[dim - 1] = TubeCrossSection::full_turn;
  return period;
}
} // namespace

template <int dim>
TubeManifold<dim>::TubeManifold(const TubeLaw &law,
                                const Part part,
                                const std::shared_ptr<const Centreline> &centreline)
    : dealii::ChartManifold<dim, dim, dim>(periodicity<dim>(part == Part::rings)),
      law(law),
      part(part),
      centreline(centreline)
{
  Assert(dim == 3 || centreline == nullptr, dealii::ExcInternalError());
}

template <int dim>
std::unique_ptr<dealii::Manifold<dim>> TubeManifold<dim>::clone() const
{
  return std::make_unique<TubeManifold<dim>>(law, part, centreline);
}

template <int dim>
double TubeManifold<dim>::radius(const TubeLaw &law, const double x, const double s)
{
  const double inner_radius = 0.5 * law.inner_diameter(x);
  return s <= 1. || law.is_rigid() ? inner_radius * s
                                   : inner_radius + law.wall_thickness(x) * (s - 1.);
}

template <int dim>
Point<dim> TubeManifold<dim>::pull_back(const Point<dim> &place) const
{
  Point<dim> point = place;
  if constexpr (dim == 3)
    if (centreline != nullptr)
      point = straightened(*centreline, place);
  const double x = point[0];
  Point<dim> chart_point;
  chart_point[0] = x;
  if constexpr (dim == 2)
    chart_point[1] = scaled_radius(law, x, point[1]);
  else
  {
    // What is across the axis, over the radius times the scaled radius.
    const double distance = std::hypot(point[1], point[2]);
    const double factor = distance > 0. ? scaled_radius(law, x, distance) / distance : 0.;
    const Point<2> scaled(factor * point[1], factor * point[2]);
    const Point<2> place = part == Part::rings ? TubeCrossSection::place(scaled) : scaled;
    chart_point[1] = place[0];
    chart_point[2] = place[1];
  }
  return chart_point;
}

template <int dim>
Point<dim> TubeManifold<dim>::push_forward(const Point<dim> &chart_point) const
{
  const double x = chart_point[0];
  Point<dim> point;
  point[0] = x;
  if constexpr (dim == 2)
    point[1] = radius(law, x, chart_point[1]);
  else
  {
    const Point<2> scaled = part == Part::rings
                                ? TubeCrossSection::point(chart_point[1], chart_point[2])
                                : Point<2>(chart_point[1], chart_point[2]);
    const double distance = std::hypot(scaled[0], scaled[1]);
    const double factor = distance > 0. ? radius(law, x, distance) / distance : 0.;
    point[1] = factor * scaled[0];
    point[2] = factor * scaled[1];
    if (centreline != nullptr)
      return bent(*centreline, point);
  }
  return point;
}

template class TubeManifold<2>;
template class TubeManifold<3>;
} // namespace Continua
