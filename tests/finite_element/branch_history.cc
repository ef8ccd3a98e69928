// Internal displacements over a step against the update worked out by hand, and what they are mixed
// to.

#include <continua/finite_element/branch_history.h>

#include "../check.h"
#include "small_problem.h"

#include <cmath>

using namespace Continua;
using namespace dealii;

int main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(mesh, {2, 1});
  Space<2> space(mesh, SpaceParameters(), Model::plane_strain, 1);
  space.distribute();

  // Two solids with a branch of 0.5 s in common, one of them with a spring besides; and a fluid.
  const double infinite = std::numeric_limits<double>::infinity();
  std::vector<Material> materials(3);
  materials[0].branches = {Branch{7., infinite}, Branch{3., 0.5}};
  materials[1].branches = {Branch{11., 0.5}};
  materials[2].viscosity = 1.;
  BranchHistory history(materials);
  history.reinit(space);
  check::is_true("equal relaxation times share a vector", history.vectors().size() == 2 * 2);

  DistributedVector velocity = space.velocity_vector(), mixture = velocity;
  velocity = 2.;
  const Step step = euler_step(0., 0.25, Update::implicit);
  history.predict(step, velocity);
  history.correct(step, velocity);
  history.finish(step);
  // D = dt U and D = dt U / (1 + dt/tau): 0.5 and 1/3.
  check::absolute("displacement", history.displacement().linfty_norm(), 0.5, 1e-15);
  check::absolute("branch that relaxes", history.internal_displacement(0.5).linfty_norm(), 1. / 3.,
                  1e-15);
  check::is_true("a solid has a mixture", history.mix(materials[0], mixture));
  check::absolute("its size", mixture.linfty_norm(), 7. * 0.5 + 3. / 3., 1e-14);
  history.mix(materials[1], mixture);
  check::absolute("the other solid's", mixture.linfty_norm(), 11. / 3., 1e-14);
  check::is_true("a fluid has none", !history.mix(materials[2], mixture));
  check::absolute("stiffness of the step", history.step_stiffness(materials[0], step),
                  7. * 0.25 + 3. * 0.25 / 1.5, 1e-15);
  check::absolute("of a fluid", history.step_stiffness(materials[2], step), 0., 0.);

  // A Crank-Nicolson step from there with U = 2 throughout: D + dt U, and (D + h U)/(1 + h/tau)
  // twice that minus D.
  const Step half = crank_nicolson_step(0.25, 0.25);
  history.predict(half, velocity);
  history.correct(half, velocity);
  history.finish(half);
  check::absolute("displacement after two steps", history.displacement().linfty_norm(), 1., 1e-15);
  const double middle = (1. / 3. + 0.125 * 2.) / (1. + 0.125 / 0.5);
  check::absolute("branch after two steps", history.internal_displacement(0.5).linfty_norm(),
                  2. * middle - 1. / 3., 1e-15);
  // Long steps that average take the exponential update, and say so.
  check::is_true("a slow branch is not exponential", history.exponential_branches(half).empty());
  check::is_true("a fast one is",
                 history.exponential_branches(crank_nicolson_step(0., 0.6)).size() == 1);
}
