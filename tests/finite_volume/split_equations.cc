// The equations of the segregated loop are those of CellWiseSystem: the residual of all four blocks
// of rows, the pressures' part of it, single entries, and vectors there and back.

#include <continua/finite_volume/split_equations.h>

#include "cell_wise_step.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_split_equations
{
namespace
{
using namespace cell_wise_meshes;

template <int dim>
void test(const std::string &name,
          const Model model,
          const Formulation formulation,
          const bool correct_fluxes)
{
  CellWiseParameters parameters;
  parameters.formulation = formulation;
  CellWiseCoefficients coefficients = make_coefficients();
  coefficients.with_pressure = parameters.has_pressure();
  coefficients.correct_fluxes = correct_fluxes;
  const CellWiseStep<dim> step(
      [](Triangulation<dim> &mesh)
      {
        make_box(mesh, 4);
        shear(mesh);
      },
      model, coefficients,
      [](Problem &problem)
      {
        set_roller(problem.conditions[0]);
        set_free(problem.conditions[1]);
      },
      parameters);
  const CellWiseSpace<dim> &space = step.space;
  SplitEquations<dim> equations(step.system);
  equations.reinit();
  using Vector = typename SplitEquations<dim>::Vector;

  DistributedVector velocity = space.velocity_vector(), pressure = space.pressure_vector(),
                    momentum = velocity, mass = pressure;
  fill_at_random(velocity, 1);
  fill_at_random(pressure, 2);
  Vector unknowns = equations.vector();
  equations.pack(velocity, pressure, unknowns);
  DistributedVector velocity_again = space.velocity_vector(),
                    pressure_again = space.pressure_vector();
  equations.unpack(unknowns, velocity_again, pressure_again);
  velocity_again.add(-1., velocity);
  double difference = velocity_again.linfty_norm();
  if (parameters.has_pressure())
  {
    pressure_again.add(-1., pressure);
    difference = std::max(difference, pressure_again.linfty_norm());
  }
  check::absolute(name + ": there and back", difference, 0., 0.);
  check::is_true(name + ": pressures", equations.has_pressure() == parameters.has_pressure());

  // Right sides that the unknowns satisfy; then nothing is left of any block.
  step.system.multiply(velocity, pressure, momentum, mass);
  step.system.set_prescribed(velocity, momentum);
  Vector right_side = equations.vector(), residual = equations.vector();
  equations.pack(momentum, mass, right_side);
  unknowns.update_ghost_values();
  double left = 0.;
  unsigned int n_rows = 0;
  std::vector<typename SplitEquations<dim>::Rows> blocks = {equations.cell_momentum(),
                                                            equations.face_momentum()};
  if (parameters.has_pressure())
  {
    blocks.push_back(equations.cell_mass());
    blocks.push_back(equations.face_pressure());
  }
  for (const auto &rows : blocks)
  {
    check::is_true(name + ": blocks follow each other", rows.first == n_rows);
    n_rows = rows.second;
    equations.residual(rows, right_side, unknowns, residual);
    for (unsigned int row = rows.first; row < rows.second; ++row)
      left = std::max(left, std::abs(residual.begin()[row]));
  }
  const double size = right_side.linfty_norm();
  check::absolute(name + ": residual", largest(left) / size, 0., 1e-13);
  check::is_true(name + ": all rows", n_rows == right_side.locally_owned_size());

  // A pressure's part of the rows of momentum is what they have without any velocity.
  DistributedVector rest = space.velocity_vector(), forces = rest;
  step.system.multiply(rest, pressure, forces, mass);
  step.system.set_prescribed(rest, forces);
  Vector gradient = equations.vector();
  for (const auto &rows : {equations.cell_momentum(), equations.face_momentum()})
    equations.add_pressure_gradient(rows, -3., unknowns, gradient);
  double error = 0.;
  for (unsigned int i = 0; i < forces.locally_owned_size(); ++i)
    error = std::max(error, std::abs(gradient.begin()[i] +
                                     (parameters.has_pressure() ? 3. * forces.begin()[i] : 0.)));
  check::absolute(name + ": pressures' part", largest(error) / size, 0., 1e-13);

  // The entry of a cell's equation of state on its own pressure: V/(K b) where fluxes are not
  // corrected; that of its velocity on itself at least mass V.
  double own = 0.;
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
  {
    const auto &volume = space.mesh.cells()[cell];
    const unsigned int row = equations.velocity_index(space.velocities.of_cell(cell));
    if (row != step.cell_row(cell))
      own = 1.;
    if (equations.entry(row, row) < coefficients.mass[volume.material_id] * volume.volume)
      own = 1.;
    if (!parameters.has_pressure())
      continue;
    const unsigned int state = equations.pressure_index(space.pressures.of_cell(cell));
    if (state != equations.cell_mass().first + step.cell_pressure_row(cell))
      own = 1.;
    if (!correct_fluxes &&
        std::abs(equations.entry(state, state) /
                     (coefficients.compressibility[volume.material_id] * volume.volume) -
                 1.) > 1e-13)
      own = 1.;
  }
  check::is_true(name + ": places and diagonals", largest(own) == 0.);
}
} // namespace

UNIT_TEST(split_equations)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  test<2>("2-D", Model::plane_strain, Formulation::velocity_pressure, true);
  test<2>("axisymmetric", Model::axisymmetric, Formulation::velocity_pressure, false);
  test<2>("without a pressure", Model::plane_strain, Formulation::velocity, false);
  test<3>("3-D", Model::three_dimensional, Formulation::velocity_pressure, false);
}
} // namespace test_of_split_equations
