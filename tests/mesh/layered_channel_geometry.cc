#include <continua/mesh/layered_channel_geometry.h>

#include "../unit_test.h"
#include "mesh_measures.h"

namespace test_of_layered_channel_geometry
{
using namespace Continua;

UNIT_TEST(layered_channel_geometry)
{
  LayeredChannelGeometry<2>::Parameters plane;
  plane.length = 10.;
  plane.axial_cells = 5;
  plane.stack.fluid_depth = 2.;
  plane.stack.fluid_cells = 4;
  plane.stack.fluid_grading = 0.25;
  plane.stack.wall_thicknesses = {0.5, 0.25};
  plane.stack.wall_cells = {2, 1};
  const measures::Measures<2> channel(LayeredChannelGeometry<2>{plane});
  check::absolute("cells", channel.mesh.n_cells(), 35., 0.);
  check::relative("fluid", channel.region("fluid"), 20., 1e-13);
  check::relative("wall 1", channel.region("wall 1"), 5., 1e-13);
  check::relative("wall 2", channel.region("wall 2"), 2.5, 1e-13);
  check::relative("inlet", channel.boundary("inlet"), 2., 1e-13);
  check::relative("outlet", channel.boundary("outlet"), 2., 1e-13);
  check::relative("wall inlet end", channel.boundary("wall inlet end"), 0.75, 1e-13);
  check::relative("wall outlet end", channel.boundary("wall outlet end"), 0.75, 1e-13);
  check::relative("bottom", channel.boundary("bottom"), 10., 1e-13);
  check::relative("top", channel.boundary("top"), 10., 1e-13);

  LayeredChannelGeometry<3>::Parameters space;
  space.length = 10.;
  space.width = 3.;
  space.stack.fluid_depth = 2.;
  space.stack.wall_thicknesses = {0.5};
  space.stack.wall_cells = {1};
  const measures::Measures<3> duct(LayeredChannelGeometry<3>{space});
  check::relative("duct: fluid", duct.region("fluid"), 60., 1e-13);
  check::relative("duct: wall", duct.region("wall"), 15., 1e-13);
  check::relative("duct: inlet", duct.boundary("inlet"), 6., 1e-13);
  check::relative("duct: wall outlet end", duct.boundary("wall outlet end"), 1.5, 1e-13);
  check::relative("duct: top", duct.boundary("top"), 30., 1e-13);
  check::relative("duct: back", duct.boundary("back"), 25., 1e-13);
  check::relative("duct: front", duct.boundary("front"), 25., 1e-13);
}
} // namespace test_of_layered_channel_geometry
