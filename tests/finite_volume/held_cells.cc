// With the cells given, faces and pressures are those that belong to them: of a linear displacement
// under the tractions of its stress, and of random ones; values that are held besides stay.

#include <continua/finite_volume/held_cells.h>

#include "cell_wise_step.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_held_cells
{
namespace
{
using namespace cell_wise_meshes;

/// u = (0.01 x, -0.02 y, 0.03 z), in axisymmetry (0.01 x, -0.02 r).
template <int dim>
dealii::Tensor<1, dim> stretch(const dealii::Point<dim> &p)
{
  dealii::Tensor<1, dim> u;
  u[0] = 0.01 * p[0];
  u[1] = -0.02 * p[1];
  if (dim == 3)
    u[dim - 1] = 0.03 * p[dim - 1];
  return u;
}

/// mu = 3 Pa, K = 2 Pa: stress 2 mu dev(eps) + K tr(eps). x = 1 and y = 1 are loaded with it, the
/// other boundaries are rollers, which the displacement allows.
template <int dim>
void check_linear(const Model model)
{
  const std::string name = model == Model::axisymmetric ? "axisymmetric" : dim == 2 ? "2-D" : "3-D";
  CellWiseCoefficients coefficients = make_coefficients();
  coefficients.mass = {0., 0.};
  const CellWiseStep<dim> step(
      [](Triangulation<dim> &mesh)
      {
        make_uniform_box(mesh, 3);
        grade(mesh);
      },
      model, coefficients,
      [](Problem &problem)
      {
        for (unsigned int b = 0; b < 2 * dim; ++b)
        {
          set_roller(problem.conditions[b]);
          if (b == 1 || b == 3)
            set_free(problem.conditions[b]);
        }
      });
  const CellWiseSpace<dim> &space = step.space;
  const DistributedVector exact = velocity_field<dim>(space, stretch<dim>);
  const double trace =
      0.01 - 0.02 + (model == Model::axisymmetric ? -0.02 : 0.) + (dim == 3 ? 0.03 : 0.);
  DistributedVector momentum = space.velocity_vector(), mass = space.pressure_vector();
  for (const auto &face : step.conditions.faces())
  {
    const auto &surface = space.mesh.faces()[face.face];
    for (unsigned int c = 0; c < 2; ++c)
      if (surface.boundary_id == 2 * c + 1)
        momentum.begin()[face.index + c] =
            face.weight * (2. * 3. * ((c == 0 ? 0.01 : -0.02) - trace / 3.) + 2. * trace);
  }
  step.system.set_prescribed(exact, momentum);
  HeldCells<dim> held(step.system);
  held.reinit({}, {});
  DistributedVector displacement = space.velocity_vector(), pressure = space.pressure_vector();
  std::copy_n(exact.begin(), dim * space.mesh.n_owned_cells(), displacement.begin());
  held.solve(momentum, mass, displacement, pressure);
  displacement.add(-1., exact);
  check::absolute(name + ": faces", displacement.linfty_norm(), 0., 1e-14);
  pressure.add(2. * trace);
  check::absolute(name + ": pressures", pressure.linfty_norm(), 0., 1e-13);
}

/// A solution that was made up; then some faces and pressures are held at other values.
void check_random()
{
  const CellWiseStep<2> step([](Triangulation<2> &mesh) { make_box(mesh, 4); }, Model::plane_strain,
                             make_coefficients(),
                             [](Problem &problem) { set_free(problem.conditions[1]); });
  const CellWiseSpace<2> &space = step.space;
  DistributedVector velocity = space.velocity_vector(), pressure = space.pressure_vector(),
                    momentum = velocity, mass = pressure;
  fill_at_random(velocity, 1);
  fill_at_random(pressure, 2);
  std::vector<bool> velocity_is_held(space.velocities.n_owned(), false),
      pressure_is_held(space.pressures.n_owned(), false);
  for (unsigned int i = 0; i < velocity_is_held.size(); i += 3)
    velocity_is_held[i] = true;
  for (unsigned int i = 0; i < pressure_is_held.size(); i += 3)
    pressure_is_held[i] = true;
  step.system.multiply(velocity, pressure, momentum, mass);
  step.system.set_prescribed(velocity, momentum);
  DistributedVector found = space.velocity_vector(), found_pressure = space.pressure_vector();
  for (unsigned int i = 0; i < found.locally_owned_size(); ++i)
    if (i / 2 < space.mesh.n_owned_cells() || velocity_is_held[i / 2])
      found.begin()[i] = velocity.begin()[i];
  for (unsigned int i = 0; i < pressure_is_held.size(); ++i)
    if (pressure_is_held[i])
      found_pressure.begin()[i] = pressure.begin()[i];
  // What is in the rows of held values does not count.
  for (unsigned int i = 0; i < momentum.locally_owned_size(); ++i)
    if (velocity_is_held[i / 2])
      momentum.begin()[i] = 99.;
  for (unsigned int i = 0; i < pressure_is_held.size(); ++i)
    if (pressure_is_held[i])
      mass.begin()[i] = 99.;
  HeldCells<2> held(step.system);
  held.reinit(velocity_is_held, pressure_is_held);
  held.solve(momentum, mass, found, found_pressure);
  found.add(-1., velocity);
  found_pressure.add(-1., pressure);
  check::absolute("made up: velocity", found.linfty_norm(), 0., 1e-11);
  check::absolute("made up: pressure", found_pressure.linfty_norm(), 0., 1e-11);
}
} // namespace

UNIT_TEST(held_cells)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  check_linear<2>(Model::plane_strain);
  check_linear<2>(Model::axisymmetric);
  check_linear<3>(Model::three_dimensional);
  check_random();
}
} // namespace test_of_held_cells
