// The compliance of walls that are given by formulas: one that yields to every pressure alike, one
// that yields to the mean of the pressure only, and one that moves against the pressure.

#include <continua/finite_element/solvers/interface_compliance.h>

#include "../unit_test.h"
#include "small_problem.h"

#include <cmath>

namespace test_of_interface_compliance
{
using namespace Continua;
using namespace dealii;

UNIT_TEST(interface_compliance)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(mesh, {8, 2});
  Space<2> space(mesh, SpaceParameters(), Model::plane_strain, 1);
  space.distribute();
  // The nodes at y = 2, pushed upwards and a little to the right.
  const auto is_at_the_wall = [](const Point<2> &x) { return x[1] > 1.9; };
  const DistributedVector load = small_problem::interpolated<2>(
      space,
      [&](const Point<2> &x) {
        return is_at_the_wall(x) ? Tensor<1, 2>({0.1 * x[0], 2. + x[0]}) : Tensor<1, 2>();
      });
  std::vector<unsigned int> nodes;
  std::vector<types::global_dof_index> indices(space.velocity_element.n_dofs_per_cell());
  std::vector<bool> is_known(space.velocity_owned.n_elements(), false);
  for (const auto &cell : space.velocity_dofs.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      cell->get_dof_indices(indices);
      // The two components of a node have neighbouring numbers in an element.
      for (const unsigned int index : indices)
        if (space.velocity_owned.is_element(index))
        {
          const unsigned int i = space.velocity_owned.index_within_set(index);
          if (!is_known[i])
            nodes.push_back(i);
          is_known[i] = true;
        }
    }

  using Inverse = std::function<void(DistributedVector &, const DistributedVector &)>;
  const auto probe = [&](const double volume, const Inverse &inverse)
  { return interface_compliance<2>(space, nodes, load, volume, inverse); };

  const DistributedVector everywhere =
      probe(16., [](DistributedVector &velocity, const DistributedVector &force)
            { velocity.equ(3., force); });
  const DistributedVector wanted = small_problem::interpolated<2>(
      space,
      [&](const Point<2> &x) {
        return is_at_the_wall(x) ? Tensor<1, 2>({3., 3.}) : Tensor<1, 2>();
      });
  DistributedVector error = everywhere;
  error.add(-1., wanted);
  check::absolute("yields to all alike: 3 at the interface, 0 elsewhere", error.linfty_norm(), 0.,
                  1e-13);

  const Inverse by_mean = [&](DistributedVector &velocity, const DistributedVector &force)
  { velocity.equ(3. * (force * load) / (load * load), load); };
  // Waves much longer than the body tell no difference; short ones have no mean.
  check::relative("yields to the mean, long waves", probe(1e9, by_mean).linfty_norm(), 3., 1e-6);
  check::is_true("yields to the mean, short waves", probe(40., by_mean).linfty_norm() < 1.);

  const DistributedVector against =
      probe(16., [](DistributedVector &velocity, const DistributedVector &force)
            { velocity.equ(-1., force); });
  check::absolute("moves against the pressure: no compliance", against.linfty_norm(), 0., 0.);
}
} // namespace test_of_interface_compliance
