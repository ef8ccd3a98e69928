#include <continua/mesh/grading.h>
#include <continua/mesh/structured_mesh.h>
#include <continua/mesh/tube_geometry.h>

namespace Continua
{
TubeGeometry::Parameters TubeGeometry::Parameters::read(ParameterSection geometry,
                                                        ParameterSection mesh)
{
  Parameters parameters;
  LayeredStack &stack = parameters.stack;
  double inner_diameter = 2. * stack.fluid_depth;
  geometry.add("Inner diameter", inner_diameter, Dimensions::length,
               "Diameter of the fluid column [m]", Range::positive());
  stack.fluid_depth = 0.5 * inner_diameter;
  geometry.add("Length", parameters.length, Dimensions::length, "Extent along the axis x [m]",
               Range::positive());
  geometry.add("Wall thicknesses", stack.wall_thicknesses, Dimensions::length,
               "Thickness of each layer of the wall, from the inner to the outer one [m]",
               Range::positive());
  if (stack.wall_thicknesses.empty())
    geometry.refuse("Wall thicknesses", "the list is empty", "Give at least one thickness");

  mesh.add("Axial cells", parameters.axial_cells, "Coarse cells along the axis", 1);
  mesh.add("Axial grading", parameters.axial_grading, Dimensions::none,
           "Size of the cells at both ends over that in the middle", grading_range);
  mesh.add("Radial cells", stack.fluid_cells, "Coarse cells across the fluid's radius", 1);
  mesh.add("Radial grading", stack.fluid_grading, Dimensions::none,
           "Size of the fluid's cell at the wall over that at the axis; below one the cells are "
           "small at the wall",
           grading_range);
  stack.read_wall_cells(mesh);
  return parameters;
}

TubeGeometry::TubeGeometry(const Parameters &parameters) : parameters(parameters) {}

std::vector<std::string> TubeGeometry::regions() const
{
  return parameters.stack.region_names();
}

std::vector<std::string> TubeGeometry::boundaries() const
{
  return {"inlet", "outlet", "wall inlet end", "wall outlet end", "axis", "outside"};
}

void TubeGeometry::create(dealii::Triangulation<2> &triangulation) const
{
  const LayeredStack &stack = parameters.stack;
  const std::vector<double> axial = symmetrically_graded_points(
      0., parameters.length, parameters.axial_cells, parameters.axial_grading);
  StructuredMesh<2>({axial, stack.points()})
      .create(
          triangulation, [&stack](const auto &cell) { return stack.region(cell[1]); },
          [&stack](const auto &cell, const unsigned int face)
          { return stack.boundary(cell[1], face); });
}
} // namespace Continua
