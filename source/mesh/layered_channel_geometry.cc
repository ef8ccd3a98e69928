#include <continua/mesh/grading.h>
#include <continua/mesh/layered_channel_geometry.h>
#include <continua/mesh/structured_extent.h>
#include <continua/mesh/structured_mesh.h>

namespace Continua
{
template <int dim>
typename LayeredChannelGeometry<dim>::Parameters
LayeredChannelGeometry<dim>::Parameters::read(ParameterSection geometry, ParameterSection mesh)
{
  Parameters parameters;
  LayeredStack &stack = parameters.stack;
  geometry.add("Length", parameters.length, Dimensions::length, "Extent along x [m]",
               Range::positive());
  geometry.add("Fluid depth", stack.fluid_depth, Dimensions::length,
               "Distance from the bottom to the wall [m]", Range::positive());
  geometry.add("Layer thicknesses", stack.wall_thicknesses, Dimensions::length,
               "Thickness of each layer of the wall, from the fluid outwards [m]",
               Range::positive());
  if (stack.wall_thicknesses.empty())
    geometry.refuse("Layer thicknesses", "the list is empty", "Give at least one thickness");

  mesh.add("Axial cells", parameters.axial_cells, "Coarse cells along x", 1);
  mesh.add("Fluid cells", stack.fluid_cells, "Coarse cells across the fluid", 1);
  mesh.add("Fluid grading", stack.fluid_grading, Dimensions::none,
           "Size of the fluid's cell at the wall over that at the bottom; below one the cells are "
           "small at the wall",
           grading_range);
  stack.read_wall_cells(mesh);
  if (dim == 3)
  {
    geometry.add("Width", parameters.width, Dimensions::length, "Extent along z [m]",
                 Range::positive());
    mesh.add("Width cells", parameters.width_cells, "Coarse cells along z", 1);
  }
  return parameters;
}

template <int dim>
LayeredChannelGeometry<dim>::LayeredChannelGeometry(const Parameters &parameters)
    : parameters(parameters)
{
}

template <int dim>
std::vector<std::string> LayeredChannelGeometry<dim>::regions() const
{
  return parameters.stack.region_names();
}

template <int dim>
std::vector<std::string> LayeredChannelGeometry<dim>::boundaries() const
{
  std::vector<std::string> names = {"inlet",           "outlet", "wall inlet end",
                                    "wall outlet end", "bottom", "top"};
  if (dim == 3)
    names.insert(names.end(), {"back", "front"});
  return names;
}

template <int dim>
void LayeredChannelGeometry<dim>::create(dealii::Triangulation<dim> &triangulation) const
{
  const LayeredStack &stack = parameters.stack;
  std::vector<std::vector<double>> points(dim);
  points[0] = {0.};
  append_graded_cells(points[0], parameters.length, parameters.axial_cells, 1.);
  points[1] = stack.points();
  if constexpr (dim == 3)
  {
    points[2] = {0.};
    append_graded_cells(points[2], parameters.width, parameters.width_cells, 1.);
  }
  StructuredMesh<dim>(points).create(
      triangulation, [&stack](const auto &cell) { return stack.region(cell[1]); },
      [&stack](const auto &cell, const unsigned int face)
      { return stack.boundary(cell[1], face); });
}

template <int dim>
MeshExtent LayeredChannelGeometry<dim>::extent() const
{
  std::vector<unsigned int> cells = {parameters.axial_cells, parameters.stack.n_cells()};
  if (dim == 3)
    cells.push_back(parameters.width_cells);
  return structured_extent(cells);
}

template <int dim>
std::unique_ptr<Geometry<dim>> LayeredChannelGeometry<dim>::coarsened(const double most_cells) const
{
  // The cells across the layers stay.
  Parameters coarse = parameters;
  const std::vector<unsigned int> cells =
      coarsened_cells({coarse.axial_cells, dim == 3 ? coarse.width_cells : 1},
                      most_cells / parameters.stack.n_cells());
  coarse.axial_cells = cells[0];
  if (dim == 3)
    coarse.width_cells = cells[1];
  return std::make_unique<LayeredChannelGeometry<dim>>(coarse);
}

template class LayeredChannelGeometry<2>;
template class LayeredChannelGeometry<3>;
} // namespace Continua
