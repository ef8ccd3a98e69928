// What faces do at once when they are loaded: with the cells where they are a face deforms like a
// layer of half a cell, by t (h/2)/(K + 4/3 mu) along its normal and t (h/2)/mu across it; a fluid
// and a solid with a dash pot do not.

#include <continua/finite_volume/loaded_faces.h>

#include "cell_wise_step.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_loaded_faces
{
namespace
{
using namespace cell_wise_meshes;

/// Cells of width h in a block that rollers hold but on x = 1; K = 2 Pa and mu = 3 Pa.
template <int dim>
void check_block(const Model model)
{
  const std::string name = model == Model::axisymmetric ? "axisymmetric" : dim == 2 ? "2-D" : "3-D";
  const double h = 0.25;
  const CellWiseStep<dim> step([](Triangulation<dim> &mesh) { make_uniform_box(mesh, 4); }, model,
                               make_coefficients(),
                               [](Problem &problem)
                               {
                                 for (BoundaryCondition &condition : problem.conditions)
                                   set_roller(condition);
                                 set_free(problem.conditions[1]);
                                 problem.materials[0].compression = Compression::elastic(0.5);
                               });
  const CellWiseSpace<dim> &space = step.space;
  LoadedFaces<dim> faces(space, step.problem, step.conditions, step.operators, step.closure,
                         step.parameters);
  faces.reinit();
  check::is_true(name + ": there is a spring", faces.exist());

  DistributedVector forces = space.velocity_vector(), displacement = forces,
                    pressure = space.pressure_vector();
  forces.add(9.); // on cells and walls they do not count
  for (const auto &face : step.conditions.faces())
  {
    const bool is_loaded = space.mesh.faces()[face.face].boundary_id == 1;
    for (unsigned int c = 0; c < dim; ++c)
      if (is_loaded || face.prescribed[c][c] < 0.5)
        forces.begin()[face.index + c] = is_loaded && c == 0 ? 0.3 * face.weight : 0.;
  }
  faces.respond(forces, displacement, pressure);
  const double deformation = 0.3 * 0.5 * h / (2. + 4.);
  double moved = 0., pressures = 0.;
  for (unsigned int i = 0; i < dim * space.mesh.n_owned_cells(); ++i)
    moved = std::max(moved, std::abs(displacement.begin()[i]));
  for (const auto &face : step.conditions.faces())
  {
    const auto &surface = space.mesh.faces()[face.face];
    const bool is_loaded = surface.boundary_id == 1;
    for (unsigned int c = 0; c < dim; ++c)
      moved = std::max(moved, std::abs(displacement.begin()[face.index + c] -
                                       (is_loaded && c == 0 ? deformation : 0.)));
    if (is_loaded)
    {
      // p = -K div U: on the face over half a cell, in the cell over a whole one.
      pressures = std::max(
          {pressures,
           std::abs(pressure.begin()[space.local_pressure(space.pressures.of_face(face.face, 0))] +
                    2. * deformation / (0.5 * h)),
           std::abs(pressure.begin()[step.cell_pressure_row(surface.owner)] +
                    2. * deformation / h)});
    }
  }
  check::absolute(name + ": faces deform", largest(moved), 0., 1e-15);
  check::absolute(name + ": their pressures", largest(pressures), 0., 1e-14);
}

/// A shear traction on the right side of one row of cells whose other sides are held.
void check_shear()
{
  const CellWiseStep<2> step(
      [](Triangulation<2> &mesh)
      {
        dealii::GridGenerator::subdivided_hyper_rectangle(mesh, std::vector<unsigned int>{4, 1},
                                                          dealii::Point<2>(),
                                                          dealii::Point<2>(1., 1.), true);
        for (const auto &cell : mesh.active_cell_iterators())
          cell->set_material_id(0);
      },
      Model::plane_strain, make_coefficients(),
      [](Problem &problem)
      {
        set_free(problem.conditions[1]);
        problem.materials[0].compression = Compression::elastic(0.5);
      });
  LoadedFaces<2> faces(step.space, step.problem, step.conditions, step.operators, step.closure,
                       step.parameters);
  DistributedVector forces = step.space.velocity_vector(), displacement = forces,
                    pressure = step.space.pressure_vector();
  for (const auto &face : step.conditions.faces())
    if (step.space.mesh.faces()[face.face].boundary_id == 1)
      forces.begin()[face.index + 1] = 0.3 * face.weight;
  faces.respond(forces, displacement, pressure);
  double moved = 0.;
  for (const auto &face : step.conditions.faces())
    if (step.space.mesh.faces()[face.face].boundary_id == 1)
      moved = displacement.begin()[face.index + 1];
  check::absolute("shear", sum(moved), 0.3 * 0.125 / 3., 1e-14);
}

void check_others()
{
  const auto exist = [](const std::function<void(Problem &)> &change)
  {
    const CellWiseStep<2> step([](Triangulation<2> &mesh) { make_box(mesh, 2); },
                               Model::plane_strain, make_coefficients(), change);
    return LoadedFaces<2>(step.space, step.problem, step.conditions, step.operators, step.closure,
                          step.parameters)
        .exist();
  };
  check::is_true("a solid beside a fluid", exist([](Problem &) {}));
  check::is_true("a dash pot beside it",
                 !exist([](Problem &problem) { problem.materials[0].shear.viscosity = 1e-3; }));
  check::is_true("fluids alone",
                 !exist([](Problem &problem) { problem.materials[0] = problem.materials[1]; }));
}
} // namespace

UNIT_TEST(loaded_faces)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  check_block<2>(Model::plane_strain);
  check_block<2>(Model::axisymmetric);
  check_block<3>(Model::three_dimensional);
  check_shear();
  check_others();
}
} // namespace test_of_loaded_faces
