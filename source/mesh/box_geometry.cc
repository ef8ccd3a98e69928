#include <continua/base/angle_entry.h>
#include <continua/mesh/box_geometry.h>
#include <continua/mesh/grading.h>
#include <continua/mesh/list_entries.h>
#include <continua/mesh/structured_extent.h>
#include <continua/mesh/structured_mesh.h>

#include <cmath>

namespace Continua
{
template <int dim>
typename BoxGeometry<dim>::Parameters BoxGeometry<dim>::Parameters::read(ParameterSection geometry,
                                                                         ParameterSection mesh,
                                                                         const bool axisymmetric)
{
  const std::string each = one_for_each_direction(dim);
  Parameters parameters;
  geometry.add("Size", parameters.size, Dimensions::length,
               "Lengths of the edges, " + each + " [m]", Range::positive());
  check_number_of_entries(geometry, "Size", parameters.size.size(), dim, each);

  geometry.add("Origin", parameters.origin, Dimensions::length,
               "The corner with the lowest coordinates, before the rotation, " + each + " [m]");
  check_number_of_entries(geometry, "Origin", parameters.origin.size(), dim, each);
  if (axisymmetric && parameters.origin[1] < 0.)
    geometry.refuse("Origin", "y is the radius in axisymmetry and cannot be negative",
                    "Give a second number that is zero or positive");

  add_angle(geometry, "Rotation", parameters.rotation,
            "Angle by which the box is turned about the point (0, 0), from x to y");
  if (axisymmetric && parameters.rotation != 0.)
    geometry.refuse("Rotation", "a box cannot be turned in axisymmetry, where x is the axis",
                    "Leave the entry out or choose another Model");

  mesh.add("Cells", parameters.cells, "Numbers of coarse cells, " + each, 1);
  check_number_of_entries(mesh, "Cells", parameters.cells.size(), dim, each);
  for (unsigned int d = 0; d < dim; ++d)
  {
    const std::string direction(1, "xyz"[d]);
    mesh.add("Grading " + direction, parameters.grading[d], Dimensions::none,
             "Size of the last cell along " + direction +
                 " over that of the first; the sizes between are a geometric sequence",
             grading_range);
  }
  return parameters;
}

template <int dim>
BoxGeometry<dim>::BoxGeometry(const Parameters &parameters, const bool axisymmetric)
    : parameters(parameters), axisymmetric(axisymmetric)
{
}

template <int dim>
std::vector<std::string> BoxGeometry<dim>::regions() const
{
  return {"body"};
}

template <int dim>
std::vector<std::string> BoxGeometry<dim>::boundaries() const
{
  if (dim == 3)
    return {"left", "right", "bottom", "top", "back", "front"};
  if (axisymmetric)
    return {"left", "right", parameters.origin[1] > 0. ? "inside" : "axis", "outside"};
  return {"left", "right", "bottom", "top"};
}

template <int dim>
void BoxGeometry<dim>::create(dealii::Triangulation<dim> &triangulation) const
{
  std::vector<std::vector<double>> points(dim);
  for (unsigned int d = 0; d < dim; ++d)
  {
    points[d] = {parameters.origin[d]};
    append_graded_cells(points[d], parameters.origin[d] + parameters.size[d], parameters.cells[d],
                        parameters.grading[d]);
  }
  const double cosine = std::cos(parameters.rotation);
  const double sine = std::sin(parameters.rotation);
  StructuredMesh<dim>(points).create(
      triangulation, [](const auto &) { return 0u; },
      [](const auto &, const unsigned int face) { return face; },
      [cosine, sine](const dealii::Point<dim> &point)
      {
        dealii::Point<dim> turned = point;
        turned[0] = cosine * point[0] - sine * point[1];
        turned[1] = sine * point[0] + cosine * point[1];
        return turned;
      });
}

template <int dim>
MeshExtent BoxGeometry<dim>::extent() const
{
  return structured_extent(parameters.cells);
}

template <int dim>
std::unique_ptr<Geometry<dim>> BoxGeometry<dim>::coarsened(const double most_cells) const
{
  Parameters coarse = parameters;
  coarse.cells = coarsened_cells(coarse.cells, most_cells);
  return std::make_unique<BoxGeometry<dim>>(coarse, axisymmetric);
}

template class BoxGeometry<2>;
template class BoxGeometry<3>;
} // namespace Continua
