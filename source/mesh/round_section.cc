#include <continua/mesh/round_section.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
using namespace dealii;

template <int dim>
RoundSection find_round_section(const Triangulation<dim> &triangulation,
                                const types::boundary_id boundary,
                                const std::set<unsigned int> &regions)
{
  // Of a high degree, since a coarse cell may stand for a large part of a circle.
  const MappingQ<dim> mapping(6);
  const FE_Nothing<dim> element;
  FEFaceValues<dim> values(mapping, element, QGauss<dim - 1>(8),
                           update_JxW_values | update_quadrature_points);
  double area = 0., radius = 0., plane = 0., deviation = 0.;
  bool first = true;
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
    {
      if (!cell->at_boundary(f) || cell->face(f)->boundary_id() != boundary ||
          regions.count(cell->material_id()) == 0)
        continue;
      values.reinit(cell, f);
      for (const unsigned int q : values.quadrature_point_indices())
        area += values.JxW(q) * (dim == 2 ? 2. * numbers::PI * values.quadrature_point(q)[1] : 1.);
      for (const unsigned int v : cell->face(f)->vertex_indices())
      {
        const Point<dim> &vertex = cell->face(f)->vertex(v);
        radius = std::max(radius, dim == 2 ? vertex[1] : std::hypot(vertex[1], vertex[dim - 1]));
        if (first)
          plane = vertex[0];
        first = false;
        deviation = std::max(deviation, std::abs(vertex[0] - plane));
      }
    }
  if (first)
    throw std::invalid_argument("the boundary has no face there");
  if (deviation > 1e-6 * radius)
    throw std::invalid_argument("the boundary does not lie in one plane across the x axis");
  // Polygons, of meshes without curved cells, have less area than the disc.
  constexpr double tolerance = 0.05;
  const double measured = area / (numbers::PI * radius * radius);
  for (const double fraction : {1., 0.5, 0.25})
    if (std::abs(measured - fraction) < tolerance * fraction)
      return {radius, fraction};
  throw std::invalid_argument(
      "the boundary is not a disc around the x axis, nor a half or a quarter of one");
}

template RoundSection
find_round_section(const Triangulation<2> &, types::boundary_id, const std::set<unsigned int> &);
template RoundSection
find_round_section(const Triangulation<3> &, types::boundary_id, const std::set<unsigned int> &);
} // namespace Continua
