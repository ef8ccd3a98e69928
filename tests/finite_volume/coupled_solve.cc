// All equations at once: a random velocity and pressure are found from what the equations make of
// them, with or without a pressure; a body under tension stretches as the theory of elasticity
// says; one that nothing holds is refused.

#include <continua/base/input_error.h>
#include <continua/finite_volume/coupled_solve.h>

#include "cell_wise_step.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_coupled_solve
{
namespace
{
using namespace cell_wise_meshes;

template <int dim>
void check_random(const std::string &name,
                  const Model model,
                  const Formulation formulation,
                  const CellWiseCoefficients &given)
{
  CellWiseParameters parameters;
  parameters.formulation = formulation;
  CellWiseCoefficients coefficients = given;
  coefficients.with_pressure = parameters.has_pressure();
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
  DistributedVector velocity = step.space.velocity_vector(),
                    pressure = step.space.pressure_vector(), momentum = velocity, mass = pressure;
  fill_at_random(velocity, 1);
  fill_at_random(pressure, 2);
  step.system.multiply(velocity, pressure, momentum, mass);
  step.system.set_prescribed(velocity, momentum);
  CoupledSolve<dim> solve(step.system);
  check::absolute(name + ": no factor yet", solve.factor_entries() + solve.factor_memory(), 0., 0.);
  solve.reinit();
  check::is_true(name + ": a factor", solve.factor_entries() > step.system.n_velocities() &&
                                          states_memory(solve.factor_memory()));
  DistributedVector found = step.space.velocity_vector(),
                    found_pressure = step.space.pressure_vector();
  StepReport report;
  solve.solve(momentum, mass, found, found_pressure, report);
  found.add(-1., velocity);
  check::absolute(name + ": velocity", found.linfty_norm(), 0., 1e-9);
  if (!parameters.has_pressure())
    return;
  found_pressure.add(-1., pressure);
  check::absolute(name + ": pressure", found_pressure.linfty_norm(), 0., 1e-9);
}

/// mu = 3 Pa and K = 4 Pa: E = 9 K mu/(3 K + mu) = 7.2 Pa, nu = E/(2 mu) - 1 = 0.2. A tension of
/// 0.6 Pa along x, rollers on x = 0 and y = 0 (z = 0), elsewhere free: strains of sigma/E and -nu
/// sigma/E; of a fixed thickness sigma (1 - nu^2)/E and -nu (1 + nu) sigma/E.
template <int dim>
void check_tension(const Model model)
{
  const std::string name = model == Model::axisymmetric ? "tension, axisymmetric"
                           : dim == 2                   ? "tension, fixed thickness"
                                                        : "tension, 3-D";
  CellWiseCoefficients coefficients;
  coefficients.mass = {0., 0.};
  coefficients.stiffness = {3., 3.};
  coefficients.compressibility = {0.25, 0.25};
  coefficients.increment_mobility = {0., 0.};
  coefficients.correct_fluxes = false;
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
          set_free(problem.conditions[b]);
          if (b % 2 == 0)
            set_roller(problem.conditions[b]);
        }
        problem.materials[0].compression = Compression::elastic(0.25);
      });
  const CellWiseSpace<dim> &space = step.space;
  DistributedVector momentum = space.velocity_vector(), mass = space.pressure_vector(),
                    displacement = momentum, pressure = mass;
  for (const auto &face : step.conditions.faces())
    if (space.mesh.faces()[face.face].boundary_id == 1)
      momentum.begin()[face.index] = 0.6 * face.weight;
  CoupledSolve<dim> solve(step.system);
  solve.reinit();
  StepReport report;
  solve.solve(momentum, mass, displacement, pressure, report);

  const bool plane = model == Model::plane_strain;
  const double along = plane ? 0.6 * (1. - 0.04) / 7.2 : 0.6 / 7.2;
  const double across = plane ? -0.2 * 1.2 * 0.6 / 7.2 : -0.2 * 0.6 / 7.2;
  const double dilatation = along + (plane ? 1. : 2.) * across;
  displacement.add(-1., velocity_field<dim>(space,
                                            [&](const dealii::Point<dim> &p)
                                            {
                                              dealii::Tensor<1, dim> u =
                                                  across * dealii::Tensor<1, dim>(p);
                                              u[0] = along * p[0];
                                              return u;
                                            }));
  check::absolute(name + ": displacement", displacement.linfty_norm(), 0., 1e-13);
  pressure.add(4. * dilatation);
  check::absolute(name + ": pressure", pressure.linfty_norm(), 0., 1e-12);
}
} // namespace

UNIT_TEST(coupled_solve)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  const CellWiseCoefficients coefficients = make_coefficients();
  CellWiseCoefficients incompressible = coefficients;
  incompressible.compressibility = {0., 0.};
  check_random<2>("2-D", Model::plane_strain, Formulation::velocity_pressure, coefficients);
  check_random<2>("incompressible", Model::plane_strain, Formulation::velocity_pressure,
                  incompressible);
  check_random<2>("axisymmetric", Model::axisymmetric, Formulation::velocity_pressure,
                  coefficients);
  check_random<2>("without a pressure", Model::plane_strain, Formulation::velocity, coefficients);
  check_random<3>("3-D", Model::three_dimensional, Formulation::velocity_pressure, coefficients);
  check_tension<2>(Model::plane_strain);
  check_tension<2>(Model::axisymmetric);
  check_tension<3>(Model::three_dimensional);

  CellWiseCoefficients steady = coefficients;
  steady.mass = {0., 0.};
  const CellWiseStep<2> loose([](Triangulation<2> &mesh) { make_uniform_box(mesh, 2); },
                              Model::plane_strain, steady,
                              [](Problem &problem)
                              {
                                for (BoundaryCondition &condition : problem.conditions)
                                  set_free(condition);
                              });
  check::throws<RunError>(
      "nothing holds it",
      [&]()
      {
        CoupledSolve<2> solve(loose.system);
        solve.reinit();
        DistributedVector momentum = loose.space.velocity_vector(),
                          mass = loose.space.pressure_vector(), velocity = momentum,
                          pressure = mass;
        fill_at_random(momentum, 1);
        StepReport report;
        solve.solve(momentum, mass, velocity, pressure, report);
      },
      "singular");
}
} // namespace test_of_coupled_solve
