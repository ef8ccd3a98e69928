#include <continua/base/input_error.h>
#include <continua/mesh/distortion.h>
#include <continua/mesh/layered_channel_geometry.h>

#include "../unit_test.h"
#include "mesh_measures.h"

namespace test_of_distortion
{
using namespace Continua;

namespace
{
/// A channel of 2 x 1 with a wall of 1 whose cells are cubes of edge 0.25.
template <int dim>
LayeredChannelGeometry<dim> channel()
{
  typename LayeredChannelGeometry<dim>::Parameters parameters;
  parameters.length = 2.;
  parameters.width = 1.;
  parameters.axial_cells = 8;
  parameters.width_cells = 4;
  parameters.stack.fluid_depth = 1.;
  parameters.stack.fluid_cells = 4;
  parameters.stack.wall_thicknesses = {1.};
  parameters.stack.wall_cells = {4};
  return LayeredChannelGeometry<dim>(parameters);
}

template <int dim>
void test(const std::string &name)
{
  const measures::Measures<dim> regular(channel<dim>());
  measures::Measures<dim> distorted(channel<dim>());
  measures::Measures<dim> again(channel<dim>());
  distort_coarse_mesh(distorted.mesh, 0.2);
  distort_coarse_mesh(again.mesh, 0.2);

  double largest = 0.;
  double of_fixed = 0.;
  unsigned int n_moved = 0;
  for (unsigned int v = 0; v < regular.mesh.n_vertices(); ++v)
  {
    const auto &vertex = regular.mesh.get_vertices()[v];
    const double moved = (distorted.mesh.get_vertices()[v] - vertex).norm();
    largest = std::max(largest, moved);
    n_moved += moved > 0. ? 1 : 0;
    bool fixed =
        vertex[0] == 0. || vertex[0] == 2. || vertex[1] == 0. || vertex[1] == 1. || vertex[1] == 2.;
    if constexpr (dim == 3)
      fixed |= vertex[2] == 0. || vertex[2] == 1.;
    if (fixed)
      of_fixed = std::max(of_fixed, moved);
  }
  // 7 x 3 inner vertices in each region, three times that in space.
  check::absolute(name + ": inner vertices move", n_moved, dim == 2 ? 42. : 126., 0.);
  check::is_true(name + ": at most a fifth of the edge", largest <= 0.05 && largest > 0.025);
  check::is_true(name + ": boundary and interface stay", of_fixed == 0.);
  check::relative(name + ": fluid", distorted.region("fluid"), dim == 2 ? 2. : 2., 1e-13);
  check::relative(name + ": wall", distorted.region("wall"), dim == 2 ? 2. : 2., 1e-13);
  check::is_true(name + ": the same again",
                 distorted.mesh.get_vertices() == again.mesh.get_vertices());

  measures::Measures<dim> untouched(channel<dim>());
  distort_coarse_mesh(untouched.mesh, 0.);
  check::is_true(name + ": zero does nothing",
                 untouched.mesh.get_vertices() == regular.mesh.get_vertices());
  check::throws<InputError>(
      name + ": too much", [&untouched] { distort_coarse_mesh(untouched.mesh, 3.); },
      "Mesh/Distortion");
}
} // namespace

UNIT_TEST(distortion)
{
  test<2>("plane");
  test<3>("space");
}
} // namespace test_of_distortion
