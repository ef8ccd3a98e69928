// The faces' own equations: what solves them stays; from other values the faces come to it, the
// cells being where they are; the pressures of walls in one pass.

#include <continua/finite_volume/face_balance.h>

#include "cell_wise_step.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_face_balance
{
namespace
{
using namespace cell_wise_meshes;

template <int dim>
void test(const std::string &name, const Model model, const bool with_fluid)
{
  const CellWiseStep<dim> step(
      [with_fluid](Triangulation<dim> &mesh)
      {
        make_box(mesh, dim == 2 ? 4 : 3);
        grade(mesh);
        if (!with_fluid)
          for (const auto &cell : mesh.active_cell_iterators())
            cell->set_material_id(0);
      },
      model, make_coefficients(),
      [](Problem &problem)
      {
        set_roller(problem.conditions[0]);
        set_free(problem.conditions[1]);
        set_free(problem.conditions[3]);
      });
  const CellWiseSpace<dim> &space = step.space;
  SplitEquations<dim> equations(step.system);
  equations.reinit();
  FaceLinks<dim> links(step.system, equations);
  links.reinit(false);
  FaceBalance<dim> faces(step.system, equations, links);
  faces.reinit();

  DistributedVector velocity = space.velocity_vector(), pressure = space.pressure_vector(),
                    momentum = velocity, mass = pressure;
  fill_at_random(velocity, 1);
  fill_at_random(pressure, 2);
  step.system.multiply(velocity, pressure, momentum, mass);
  step.system.set_prescribed(velocity, momentum);
  auto right_side = equations.vector(), exact = right_side;
  equations.pack(momentum, mass, right_side);
  equations.pack(velocity, pressure, exact);

  // Distance of the faces' values from the exact ones.
  const auto error =
      [&](const typename SplitEquations<dim>::Vector &unknowns, const bool of_velocities)
  {
    const auto rows = of_velocities ? equations.face_momentum() : equations.face_pressure();
    double result = 0.;
    for (unsigned int row = rows.first; row < rows.second; ++row)
      result = std::max(result, std::abs(unknowns.begin()[row] - exact.begin()[row]));
    return largest(result);
  };
  auto unknowns = exact;
  unknowns.update_ghost_values();
  faces.solve(right_side, unknowns);
  check::absolute(name + ": the solution stays, velocity", error(unknowns, true), 0., 1e-12);
  check::absolute(name + ": the solution stays, pressure", error(unknowns, false), 0., 1e-12);

  const auto rows = equations.face_momentum();
  for (unsigned int row = rows.first; row < rows.second; ++row)
    unknowns.begin()[row] = 0.;
  for (unsigned int row = equations.face_pressure().first; row < equations.face_pressure().second;
       ++row)
    unknowns.begin()[row] = 0.;
  unsigned int n_passes = 0;
  do
  {
    unknowns.update_ghost_values();
    faces.solve(right_side, unknowns);
    ++n_passes;
  } while (n_passes < 60 && std::max(error(unknowns, true), error(unknowns, false)) > 1e-11);
  check::absolute(name + ": found, velocity", error(unknowns, true), 0., 1e-11);
  check::absolute(name + ": found, pressure", error(unknowns, false), 0., 1e-11);

  // The pressures' own equations, the velocities being right: those from the definition at once.
  unknowns = exact;
  for (const auto &face : faces.pressures())
    unknowns.begin()[face.pressure] = 5.;
  unknowns.update_ghost_values();
  faces.solve_pressures(right_side, unknowns);
  double at_once = 0.;
  unsigned int n_from_definition = 0, n_free = 0;
  for (const auto &face : faces.pressures())
  {
    n_free += face.normal_is_free;
    if (face.from_definition)
    {
      ++n_from_definition;
      at_once = std::max(at_once,
                         std::abs(unknowns.begin()[face.pressure] - exact.begin()[face.pressure]));
    }
  }
  check::absolute(name + ": from the definition", largest(at_once), 0., 1e-12);
  check::is_true(name + ": faces of each kind", sum(n_from_definition) > 0. && sum(n_free) > 0.);
}
} // namespace

UNIT_TEST(face_balance)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  test<2>("2-D", Model::plane_strain, false);
  test<2>("axisymmetric", Model::axisymmetric, false);
  test<2>("fluid beside solid", Model::plane_strain, true);
  test<3>("3-D", Model::three_dimensional, false);
}
} // namespace test_of_face_balance
