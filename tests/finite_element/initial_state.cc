// The pressure in equilibrium with a displacement, on one and two regions.

#include <continua/finite_element/assembly/initial_state.h>

#include "../unit_test.h"
#include "small_problem.h"

namespace test_of_initial_state
{
using namespace Continua;
using namespace dealii;

UNIT_TEST(initial_state)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(mesh, {4, 2}, Point<2>(), 2.);
  small_problem::refine<2>(mesh, [](const Point<2> &x) { return x[0] > 1. && x[1] > 1.; });
  Space<2> space(mesh, SpaceParameters(), Model::plane_strain, 2);
  space.distribute();
  Problem problem;
  problem.regions = {"left", "right"};
  problem.materials.resize(2);
  problem.materials[0].compression = Compression::elastic(1. / 30.);
  problem.materials[1].compression = Compression::elastic(1. / 500.);
  std::vector<RegionOperators> operators(2);
  assemble_region_operators(space, operators);

  // div D = 0.02 + 0.06 x, so p = -K div D is linear in each region and jumps between them.
  const DistributedVector displacement = small_problem::interpolated<2>(
      space,
      [](const Point<2> &x) {
        return Tensor<1, 2>({0.02 * x[0] + 0.03 * x[0] * x[0], 0.1 * x[0]});
      });
  DistributedVector pressure = space.pressure_vector();
  solve_equilibrium_pressure(space, problem, operators, displacement, pressure);
  DistributedVector exact = small_problem::interpolated_pressure<2>(
      space, [](const Point<2> &x, const unsigned int region)
      { return -(region == 0 ? 30. : 500.) * (0.02 + 0.06 * x[0]); });
  exact.add(-1., pressure);
  check::absolute("pressure of two regions", exact.linfty_norm(), 0., 1e-9);

  problem.materials[1].compression = Compression();
  solve_equilibrium_pressure(space, problem, operators, displacement, pressure);
  exact = small_problem::interpolated_pressure<2>(
      space, [](const Point<2> &x, const unsigned int region)
      { return region == 0 ? -30. * (0.02 + 0.06 * x[0]) : 0.; });
  exact.add(-1., pressure);
  check::absolute("beside an incompressible region", exact.linfty_norm(), 0., 1e-9);
}
} // namespace test_of_initial_state
