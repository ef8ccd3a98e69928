#include <continua/mesh/geometric_indicators.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/boost_adaptors/bounding_box.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
template <int dim>
using Face = typename Triangulation<dim>::face_iterator;

template <int dim>
bool is_interface(const typename Triangulation<dim>::cell_iterator &cell,
                  const unsigned int f,
                  const std::vector<bool> &is_solid)
{
  return !cell->at_boundary(f) &&
         is_solid[cell->material_id()] != is_solid[cell->neighbor(f)->material_id()];
}

/// To the point of a face that the place in the face's own coordinates, cut off at its rim, stands
/// for.
template <int dim>
double distance(const Face<dim> &face, const Point<dim> &point)
{
  const Point<dim - 1> place = GeometryInfo<dim - 1>::project_to_unit_cell(
      face->real_to_unit_cell_affine_approximation(point));
  Point<dim> nearest;
  for (const unsigned int v : face->vertex_indices())
    nearest += GeometryInfo<dim - 1>::d_linear_shape_function(place, v) * face->vertex(v);
  return point.distance(nearest);
}
} // namespace

template <int dim>
Vector<float> interface_band(const Triangulation<dim> &triangulation,
                             const std::vector<bool> &is_solid,
                             const double width)
{
  std::vector<Face<dim>> faces;
  std::vector<BoundingBox<dim>> boxes;
  for (const auto &cell : triangulation.cell_iterators_on_level(0))
    for (const unsigned int f : cell->face_indices())
      if (!is_solid[cell->material_id()] && is_interface<dim>(cell, f, is_solid))
      {
        faces.push_back(cell->face(f));
        boxes.push_back(cell->face(f)->bounding_box());
        boxes.back().extend(width);
      }
  const auto tree = pack_rtree_of_indices(boxes);

  Vector<float> per_cell(triangulation.n_active_cells());
  std::vector<std::size_t> near;
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      bool inside = false;
      for (const unsigned int f : cell->face_indices())
        inside = inside || is_interface<dim>(cell, f, is_solid);
      near.clear();
      if (!inside)
        tree.query(boost::geometry::index::intersects(cell->bounding_box()),
                   std::back_inserter(near));
      for (const std::size_t i : near)
        for (const unsigned int v : cell->vertex_indices())
          inside = inside || distance<dim>(faces[i], cell->vertex(v)) < width;
      per_cell[cell->active_cell_index()] = inside ? 1.f : 0.f;
    }
  return per_cell;
}

template <int dim>
Vector<float> expression_indicator(const Triangulation<dim> &triangulation,
                                   const Expression &expression,
                                   const double time)
{
  Vector<float> per_cell(triangulation.n_active_cells());
  for (const auto &cell : triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      const auto value = [&](const Point<dim> &point)
      {
        double coordinates[3] = {0., 0., 0.};
        for (unsigned int c = 0; c < dim; ++c)
          coordinates[c] = point[c];
        return expression(coordinates, time);
      };
      double largest = value(cell->center());
      for (const unsigned int v : cell->vertex_indices())
        if (const double at_vertex = value(cell->vertex(v));
            at_vertex > largest || std::isnan(at_vertex)) // no number stays none
          largest = at_vertex;
      per_cell[cell->active_cell_index()] = largest;
    }
  return per_cell;
}

template Vector<float> interface_band(const Triangulation<2> &, const std::vector<bool> &, double);
template Vector<float> interface_band(const Triangulation<3> &, const std::vector<bool> &, double);
template Vector<float> expression_indicator(const Triangulation<2> &, const Expression &, double);
template Vector<float> expression_indicator(const Triangulation<3> &, const Expression &, double);
} // namespace Continua
