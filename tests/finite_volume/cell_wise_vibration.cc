// Free vibrations: waves along a bar in cells of h answer with the acceleration that differences of
// h and 2 h give; masses; a solve is the inverse of what it is of; shapes have their pressures.

#include <continua/finite_volume/cell_wise_vibration.h>

#include "cell_wise_step.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_cell_wise_vibration
{
namespace
{
using namespace cell_wise_meshes;
constexpr double density = 2.;

/// mu = 3 Pa, K = 2 Pa; rollers all around but on x = 1. Of u = sin(k x) the deviatoric stress
/// makes
/// -(4/3) mu (2 - 2 cos(k h))/h^2 u and the pressure, that of twice the step, -K (sin(k h)/h)^2 u.
template <int dim>
void test(const Model model)
{
  const std::string name = model == Model::axisymmetric ? "axisymmetric: "
                           : dim == 2                   ? "2-D: "
                                                        : "3-D: ";
  CellWiseCoefficients steady = make_coefficients();
  steady.correct_fluxes = false;
  constexpr unsigned int n = 8;
  const double h = 1. / n, wave_number = 5.;
  CellWiseStep<dim> body(
      [](Triangulation<dim> &mesh)
      {
        std::vector<unsigned int> cells(dim, 2);
        cells[0] = n;
        dealii::Point<dim> corner;
        corner[0] = 1.;
        for (unsigned int c = 1; c < dim; ++c)
          corner[c] = 2. / n;
        dealii::GridGenerator::subdivided_hyper_rectangle(mesh, cells, dealii::Point<dim>(), corner,
                                                          true);
        for (const auto &cell : mesh.active_cell_iterators())
          cell->set_material_id(0);
      },
      model, steady,
      [](Problem &problem)
      {
        for (BoundaryCondition &condition : problem.conditions)
          set_roller(condition);
        set_free(problem.conditions[1]);
        for (Material &material : problem.materials)
          material.density = density;
        problem.materials[0].compression = Compression::elastic(0.5);
      });
  const CellWiseSpace<dim> &space = body.space;
  DistributedVector velocity = space.velocity_vector(), displacement = velocity,
                    pressure = space.pressure_vector();
  velocity.add(3.);
  CellWiseVibration<dim> vibration(body.system, steady, {velocity, displacement, pressure});
  check::is_true(name + "not symmetric, has an acceleration",
                 !vibration.is_symmetric() && vibration.has_acceleration());

  const unsigned int n_unknowns = vibration.n_local_unknowns();
  std::vector<double> wave(n_unknowns, 0.), acceleration(n_unknowns);
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
    wave[dim * cell] = std::sin(wave_number * space.mesh.cells()[cell].centre[0]);
  vibration.accelerate(wave, acceleration);
  const double phase = wave_number * h;
  const double eigenvalue =
      (4. / 3. * 3. * (2. - 2. * std::cos(phase)) + 2. * std::sin(phase) * std::sin(phase)) /
      (h * h * density);
  double error = 0., across = 0.;
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const double x = space.mesh.cells()[cell].centre[0];
    for (unsigned int c = 1; c < dim; ++c)
      across = std::max(across, std::abs(acceleration[dim * cell + c]));
    if (x > 2.2 * h && x < 1. - 2.2 * h)
      error = std::max(error, std::abs(acceleration[dim * cell] - eigenvalue * wave[dim * cell]));
  }
  check::absolute(name + "acceleration of a wave", largest(error), 0., 1e-10);
  check::absolute(name + "nothing across", largest(across), 0., 1e-10);

  // p = -K du/dx over two steps.
  vibration.set_shape(wave, 1.);
  double pressures = 0., cells = 0.;
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const double x = space.mesh.cells()[cell].centre[0];
    cells = std::max(cells, std::abs(displacement.begin()[body.cell_row(cell)] - wave[dim * cell]));
    if (x > 1.2 * h && x < 1. - 1.2 * h)
      pressures =
          std::max(pressures, std::abs(pressure.begin()[body.cell_pressure_row(cell)] +
                                       2. * std::cos(wave_number * x) * std::sin(phase) / h));
  }
  check::absolute(name + "shape: displacement", largest(cells), 0., 0.);
  check::absolute(name + "shape: velocity", velocity.linfty_norm(), 0., 0.);
  check::absolute(name + "shape: pressure", largest(pressures), 0., 1e-12);

  // Mass and momentum: rho V.
  std::vector<double> mass(n_unknowns), ones(n_unknowns, 1.);
  vibration.multiply_mass(ones, mass);
  const std::vector<double> momentum = vibration.momentum(
      [](const dealii::Point<dim> &p) { return 3. * dealii::Tensor<1, dim>(p); });
  const std::vector<unsigned int> directions = vibration.directions();
  double masses = 0.;
  for (unsigned int i = 0; i < n_unknowns; ++i)
  {
    const auto &cell = space.mesh.cells()[i / dim];
    masses = std::max({masses, std::abs(mass[i] - density * cell.volume),
                       std::abs(momentum[i] - density * cell.volume * 3. * cell.centre[i % dim]),
                       directions[i] == i % dim ? 0. : 1.});
  }
  check::absolute(name + "mass and momentum", largest(masses), 0., 1e-15);

  // (K - s M) x = f, with K x = M times the acceleration.
  const double shift = 7.;
  std::vector<double> force(n_unknowns);
  for (unsigned int i = 0; i < n_unknowns; ++i)
    force[i] = mass[i] * (acceleration[i] - shift * wave[i]);
  vibration.set_shift(shift);
  vibration.solve(force);
  double inverse = 0.;
  for (unsigned int i = 0; i < n_unknowns; ++i)
    inverse = std::max(inverse, std::abs(force[i] - wave[i]));
  check::absolute(name + "a solve is the inverse", largest(inverse), 0., 1e-11);

  body.problem.materials[0].compression = Compression();
  check::is_true(name + "incompressible: no acceleration", !vibration.has_acceleration());
}
} // namespace

UNIT_TEST(cell_wise_vibration)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  test<2>(Model::plane_strain);
  test<2>(Model::axisymmetric);
  test<3>(Model::three_dimensional);
}
} // namespace test_of_cell_wise_vibration
