#include <continua/mesh/cell_point.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/geometry_info.h>

namespace Continua
{
using namespace dealii;

template <int dim>
bool cell_holds_point(const Mapping<dim> &mapping,
                      const typename Triangulation<dim>::cell_iterator &cell,
                      const Point<dim> &point,
                      Point<dim> &unit_point)
{
  constexpr double tolerance = 1e-8;
  // Most cells are told by the box of their vertices, without the iteration that inverts the
  // mapping; a curved cell may reach beyond it.
  const auto corners = cell->bounding_box().get_boundary_points();
  const double margin = 0.5 * cell->diameter();
  for (unsigned int c = 0; c < dim; ++c)
    if (point[c] < corners.first[c] - margin || point[c] > corners.second[c] + margin)
      return false;
  try
  {
    const Point<dim> candidate = mapping.transform_real_to_unit_cell(cell, point);
    if (!GeometryInfo<dim>::is_inside_unit_cell(candidate, tolerance))
      return false;
    unit_point = GeometryInfo<dim>::project_to_unit_cell(candidate);
    return true;
  }
  catch (const typename Mapping<dim>::ExcTransformationFailed &)
  {
    return false;
  }
}

template bool cell_holds_point<2>(const Mapping<2> &,
                                  const Triangulation<2>::cell_iterator &,
                                  const Point<2> &,
                                  Point<2> &);
template bool cell_holds_point<3>(const Mapping<3> &,
                                  const Triangulation<3>::cell_iterator &,
                                  const Point<3> &,
                                  Point<3> &);
} // namespace Continua
