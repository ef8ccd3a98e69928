#include <continua/mesh/round_section.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Continua
{
using namespace dealii;

namespace
{
/// Polygons, of meshes without curved cells, have less area than the disc.
constexpr double area_tolerance = 0.05;
/// What may stand out of the plane, over the radius.
constexpr double plane_tolerance = 1e-6;

/// Two points of a disc, or of half of one, with its diameter between them: from a point of the rim
/// the farthest one is the other end of its diameter, or for half of a disc one of the corners.
template <int dim>
std::pair<Point<dim>, Point<dim>> ends_of_diameter(const std::vector<Point<dim>> &points)
{
  std::pair<Point<dim>, Point<dim>> ends{points.front(), points.front()};
  // Onto the rim, to a corner, to the other one.
  for (unsigned int step = 0; step < 3; ++step)
    ends = {*std::max_element(points.begin(), points.end(),
                              [&ends](const Point<dim> &a, const Point<dim> &b) {
                                return a.distance_square(ends.first) <
                                       b.distance_square(ends.first);
                              }),
            ends.first};
  return ends;
}
} // namespace

template <int dim>
RoundSection<dim> find_round_section(const Triangulation<dim> &triangulation,
                                     const types::boundary_id boundary,
                                     const std::set<unsigned int> &regions)
{
  // Of a high degree, since a coarse cell may stand for a large part of a circle.
  const MappingQ<dim> mapping(6);
  const FE_Nothing<dim> element;
  FEFaceValues<dim> values(mapping, element, QGauss<dim - 1>(8),
                           update_JxW_values | update_quadrature_points | update_normal_vectors);
  double area = 0.;
  Tensor<1, dim> normal, moment;
  std::map<unsigned int, Point<dim>> vertices;
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
    {
      if (!cell->at_boundary(f) || cell->face(f)->boundary_id() != boundary ||
          regions.count(cell->material_id()) == 0)
        continue;
      values.reinit(cell, f);
      for (const unsigned int q : values.quadrature_point_indices())
      {
        const Point<dim> &point = values.quadrature_point(q);
        area += values.JxW(q) * (dim == 2 ? 2. * numbers::PI * point[1] : 1.);
        normal += values.JxW(q) * values.normal_vector(q);
        moment += values.JxW(q) * point;
      }
      for (const unsigned int v : cell->face(f)->vertex_indices())
        vertices[cell->face(f)->vertex_index(v)] = cell->face(f)->vertex(v);
    }
  if (vertices.empty())
    throw std::invalid_argument("the boundary has no face there");
  if (dim == 2)
    normal = Point<dim>::unit_vector(0);
  else if (normal.norm() > 0.)
    normal /= normal.norm();
  std::vector<Point<dim>> points;
  points.reserve(vertices.size());
  for (const auto &[index, vertex] : vertices)
    points.push_back(vertex);
  const auto ends = ends_of_diameter(points);
  for (const Point<dim> &point : points)
    if (normal.norm() == 0. || std::abs((point - points.front()) * normal) >
                                   plane_tolerance * ends.first.distance(ends.second))
      throw std::invalid_argument(dim == 2
                                      ? "the boundary does not lie in one plane across the x axis"
                                      : "the boundary does not lie in one plane");

  // Whether the faces are that part of the disc around the centre.
  RoundSection<dim> disc;
  const auto fits = [&](const Point<dim> &centre, const double fraction)
  {
    double radius = 0.;
    for (const Point<dim> &point : points)
      radius = std::max(radius, point.distance(centre));
    disc = {centre, radius, fraction};
    const double measured = area / (numbers::PI * radius * radius);
    return std::abs(measured - fraction) < area_tolerance * fraction;
  };
  // Around the x axis, where the plane is across it.
  Point<dim> on_axis;
  on_axis[0] = points.front()[0];
  if (std::abs(normal[0]) > 1. - plane_tolerance)
    for (const double fraction : {1., 0.5, 0.25})
      if (fits(on_axis, fraction))
        return disc;
  if (dim == 3)
  {
    // A disc has its centre in its middle; a half of one in that of its diameter, and its middle 4
    // / (3 pi) of the radius beside.
    const Point<dim> middle(moment / area);
    if (fits(middle, 1.) || (fits(ends.first + 0.5 * (ends.second - ends.first), 0.5) &&
                             std::abs(middle.distance(disc.centre) / disc.radius -
                                      4. / (3. * numbers::PI)) < area_tolerance))
      return disc;
  }
  throw std::invalid_argument(
      dim == 2 ? "the boundary is not a disc around the x axis"
               : "the boundary is neither a disc or a half of one, nor a quarter of a disc around "
                 "the x axis");
}

template RoundSection<2>
find_round_section(const Triangulation<2> &, types::boundary_id, const std::set<unsigned int> &);
template RoundSection<3>
find_round_section(const Triangulation<3> &, types::boundary_id, const std::set<unsigned int> &);
} // namespace Continua
