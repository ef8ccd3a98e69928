// Internal displacements over a step against the update worked out by hand, what they are mixed to,
// and where they live.

#include <continua/continuum/branch_history.h>
#include <continua/continuum/state_vectors.h>

#include "../unit_test.h"

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace test_of_branch_history
{
using namespace Continua;
using namespace dealii;

UNIT_TEST(branch_history)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  // Three squares in a row, seven columns of three nodes: two solids with a branch of 0.5 s in
  // common, one of them with a spring besides; and a fluid.
  const DistributedVector prototype(complete_index_set(42), MPI_COMM_WORLD);
  std::vector<std::vector<unsigned int>> nodes(3, std::vector<unsigned int>(18));
  for (unsigned int region = 0; region < 3; ++region)
    std::iota(nodes[region].begin(), nodes[region].end(), 12 * region);

  const double infinite = std::numeric_limits<double>::infinity();
  std::vector<Material> materials(3);
  materials[0].shear.branches = {Branch{7., infinite}, Branch{3., 0.5}};
  materials[1].shear.branches = {Branch{11., 0.5}};
  materials[2].shear.viscosity = 1.;
  BranchHistory history(materials);
  history.reinit(prototype, nodes);
  StateVectors vectors;
  history.visit(vectors);
  check::is_true("equal relaxation times share a vector",
                 vectors.velocities.size() == 2 * 2 && vectors.pressures.empty());

  DistributedVector velocity = prototype, mixture = velocity, work = velocity;
  velocity = 2.;
  const Step step = euler_step(0., 0.25, Update::implicit);
  check::is_true("a fluid has no force of branches", !history.predict(2, step, velocity, mixture));
  history.advance(step, velocity, velocity);
  // D = dt U and D = dt U / (1 + dt/tau): 0.5 and 1/3.
  check::absolute("displacement", history.displacement().linfty_norm(), 0.5, 1e-15);
  check::absolute("branch that relaxes", history.internal_displacement(0.5).linfty_norm(), 1. / 3.,
                  1e-15);
  // The displacement is everywhere, in 7 x 3 nodes; the branch in two of three cells, 5 x 3 nodes.
  check::absolute("nodes with a displacement", history.displacement().l1_norm() / 0.5, 42., 1e-12);
  check::absolute("nodes with the branch", history.internal_displacement(0.5).l1_norm() * 3., 30.,
                  1e-12);
  check::is_true("a solid has a mixture", history.mix(0, mixture));
  check::absolute("its size", mixture.linfty_norm(), 7. * 0.5 + 3. / 3., 1e-14);
  mixture = 0.;
  history.mix(1, mixture);
  check::absolute("the other solid's", mixture.linfty_norm(), 11. / 3., 1e-14);
  check::is_true("a fluid has none", !history.mix(2, mixture));
  check::absolute("stiffness of the step", BranchHistory::step_stiffness(materials[0], step),
                  7. * 0.25 + 3. * 0.25 / 1.5, 1e-15);
  check::absolute("of a fluid", BranchHistory::step_stiffness(materials[2], step), 0., 0.);

  // A Crank-Nicolson step from there with U = 2 throughout: D + dt U, and (D + h U)/(1 + h/tau)
  // twice that minus D.
  const Step half = crank_nicolson_step(0.25, 0.25);
  const double known = 1. / 3. / (1. + 0.125 / 0.5);
  const double middle = (1. / 3. + 0.125 * 2.) / (1. + 0.125 / 0.5);
  mixture = 0.;
  history.predict(1, half, velocity, mixture);
  check::absolute("force known in advance", mixture.linfty_norm(), 11. * known, 1e-14);
  history.advance(half, velocity, velocity);
  check::absolute("displacement after two steps", history.displacement().linfty_norm(), 1., 1e-15);
  check::absolute("branch after two steps", history.internal_displacement(0.5).linfty_norm(),
                  2. * middle - 1. / 3., 1e-15);
  mixture = 0.;
  history.mix_balanced(1, half, mixture);
  check::absolute("mixture in the middle", mixture.linfty_norm(), 11. * middle, 1e-14);
  history.forgotten_velocity(0.5, half, velocity, work);
  check::absolute("forgotten: D / tau", work.linfty_norm(), middle / 0.5, 1e-14);

  // Long steps that average take the exponential update, and say so; it is exact for a constant
  // velocity: D_new = exp(-x) D + tau (1 - exp(-x)) U.
  check::is_true("a slow branch is not exponential", history.exponential_branches(half).empty());
  const Step long_step = crank_nicolson_step(0.5, 5.);
  check::is_true("a fast one is", history.exponential_branches(long_step).size() == 1);
  const double before = 2. * middle - 1. / 3.;
  history.advance(long_step, velocity, velocity);
  const double after = std::exp(-10.) * before + 0.5 * (1. - std::exp(-10.)) * 2.;
  check::absolute("long step", history.internal_displacement(0.5).linfty_norm(), after, 1e-14);
  // Over such a step dD = (U - forgotten) dt by definition.
  history.forgotten_velocity(0.5, long_step, velocity, work);
  check::absolute("forgotten in it", work.linfty_norm(), 2. - (after - before) / 5., 1e-14);

  // What is set from outside, after a change of the mesh, is what the next step starts from.
  StateVectors carried;
  history.visit(carried);
  *carried.velocities[2] = 0.25;
  mixture = 0.;
  history.predict(1, euler_step(5.5, 0.5, Update::implicit), velocity, mixture);
  check::absolute("set from outside", mixture.linfty_norm(), 11. * 0.25 / 2., 1e-14);
}
} // namespace test_of_branch_history
