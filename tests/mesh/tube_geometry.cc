#include <continua/mesh/tube_geometry.h>

#include "../check.h"
#include "mesh_measures.h"

using namespace Continua;

int main()
{
  TubeGeometry::Parameters parameters;
  parameters.length = 0.8;
  parameters.axial_cells = 5;
  parameters.axial_grading = 0.5;
  parameters.stack.fluid_depth = 0.005;
  parameters.stack.fluid_cells = 4;
  parameters.stack.fluid_grading = 0.2;
  parameters.stack.wall_thicknesses = {0.001};
  parameters.stack.wall_cells = {2};
  const measures::Measures<2> tube(TubeGeometry{parameters});
  check::absolute("cells", tube.mesh.n_cells(), 30., 0.);
  check::relative("fluid", tube.region("fluid"), 0.004, 1e-13);
  check::relative("wall", tube.region("wall"), 0.0008, 1e-13);
  check::relative("inlet", tube.boundary("inlet"), 0.005, 1e-13);
  check::relative("outlet", tube.boundary("outlet"), 0.005, 1e-13);
  check::relative("wall inlet end", tube.boundary("wall inlet end"), 0.001, 1e-13);
  check::relative("wall outlet end", tube.boundary("wall outlet end"), 0.001, 1e-13);
  check::relative("axis", tube.boundary("axis"), 0.8, 1e-13);
  check::relative("outside", tube.boundary("outside"), 0.8, 1e-13);

  double at_axis = 0.;
  double at_wall = 0.;
  double at_inlet = 0.;
  double in_the_middle = 0.;
  for (const auto &cell : tube.mesh.active_cell_iterators())
  {
    if (cell->at_boundary(2))
      at_axis = cell->extent_in_direction(1);
    if (cell->material_id() == 0 && cell->neighbor(3)->material_id() == 1)
      at_wall = cell->extent_in_direction(1);
    if (cell->at_boundary(0))
      at_inlet = cell->extent_in_direction(0);
    if (std::abs(cell->center()[0] - 0.4) < 1e-6)
      in_the_middle = cell->extent_in_direction(0);
  }
  check::relative("radial grading", at_wall / at_axis, 0.2, 1e-12);
  check::relative("axial grading", at_inlet / in_the_middle, 0.5, 1e-12);
}
