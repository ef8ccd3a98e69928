// The segregated loop, converged, has the solution of all equations at once: in every formulation,
// with conditions of both kinds on a face, fluid beside solid, axisymmetry, three dimensions.

#include "cell_wise_body.h"

#include <continua/finite_volume/coupled_solve.h>
#include <continua/finite_volume/segregated_solve.h>

#include "../unit_test.h"

#include <random>

namespace test_of_segregated_solve
{
namespace
{
using namespace cell_wise_meshes;

template <int dim>
void test(const std::string &name,
          const Formulation formulation,
          const Model model,
          const bool with_fluid,
          const BoundaryVelocityAs boundary_velocity = BoundaryVelocityAs::automatic,
          const bool skewed = false)
{
  Triangulation<dim> mesh(MPI_COMM_WORLD);
  make_box(mesh, dim == 2 ? 6 : 4);
  if (!with_fluid)
    for (const auto &cell : mesh.active_cell_iterators())
      cell->set_material_id(0);
  if (skewed)
    grade<dim>(mesh);
  Problem problem = make_problem<dim>(model);
  // One side is free, one slides.
  for (auto &condition : problem.conditions)
  {
    if (condition.boundary_id == 1)
      condition.normal.kind = condition.tangential.kind = BoundaryPart::Kind::traction;
    if (condition.boundary_id == 3)
      condition.tangential.kind = BoundaryPart::Kind::traction;
  }
  CellWiseParameters parameters;
  parameters.formulation = formulation;
  parameters.solution = CellWiseSolution::segregated;
  parameters.boundary_velocity_as = boundary_velocity;
  parameters.tolerance = 1e-12;
  parameters.maximum_corrections = 2000;

  CellWiseSpace<dim> space(mesh, model);
  space.distribute();
  FaceConditions<dim> conditions(space, problem.conditions);
  conditions.build();
  std::vector<CellWiseOperators> operators;
  PressureClosure closure;
  assemble_cell_operators(space, problem, conditions, parameters,
                          std::vector<bool>(problem.materials.size(), true), operators, closure);
  CellWiseSystem<dim> system(space, problem, conditions, operators, closure, parameters);
  system.reinit();
  // A step of 0.1 s: the moduli are 3 Pa, 2 Pa s and 1 Pa, the densities 1 and 2 kg/m^3.
  const double step = 0.1;
  CellWiseCoefficients coefficients;
  coefficients.with_pressure = parameters.has_pressure();
  coefficients.correct_fluxes = formulation == Formulation::velocity_pressure;
  coefficients.mass = {1. / step, 2. / step};
  coefficients.stiffness = {3. * step / 2., 2.};
  coefficients.compressibility = {2. / step, 2. / step};
  coefficients.increment_mobility = {2. / (5. * step), 0.};
  system.prepare(coefficients);

  DistributedVector momentum = space.velocity_vector(), mass = space.pressure_vector();
  DistributedVector prescribed = space.velocity_vector();
  const auto fill = [](DistributedVector &vector, const unsigned int first)
  {
    // The same on any number of ranks but for the order of the values.
    std::mt19937 generator(first);
    std::uniform_real_distribution<double> distribution(-1., 1.);
    for (double &value : vector)
      value = distribution(generator);
  };
  fill(momentum, 1);
  fill(mass, 2);
  fill(prescribed, 3);
  momentum *= 1e-2;
  mass *= 1e-3;
  // What the pressures of faces obey without an equation of state has no right side.
  for (const unsigned int row : closure.rows)
    mass.begin()[row] = 0.;
  system.set_prescribed(prescribed, momentum);

  DistributedVector velocity = space.velocity_vector(), pressure = space.pressure_vector();
  DistributedVector coupled_velocity = velocity, coupled_pressure = pressure;
  StepReport report;
  CoupledSolve<dim> coupled(system);
  coupled.reinit();
  coupled.solve(momentum, mass, coupled_velocity, coupled_pressure, report);

  unsigned int n_told = 0;
  SegregatedSolve<dim> segregated(system, [&](const LoopCorrection &) { ++n_told; });
  segregated.reinit();
  segregated.solve(momentum, mass, velocity, pressure, report);
  check::is_true(name + ", converged", !report.cap_reached && n_told == report.corrections);
  const double velocity_scale = coupled_velocity.linfty_norm(),
               pressure_scale = coupled_pressure.linfty_norm();
  velocity.add(-1., coupled_velocity);
  pressure.add(-1., coupled_pressure);
  check::absolute(name + ", velocity", velocity.linfty_norm() / velocity_scale, 0., 1e-9);
  if (parameters.has_pressure())
    check::absolute(name + ", pressure", pressure.linfty_norm() / pressure_scale, 0., 1e-9);
}
} // namespace

UNIT_TEST(segregated_solve)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  const Model plane = Model::plane_strain;
  test<2>("displacement", Formulation::displacement, plane, false);
  test<2>("velocity", Formulation::velocity, plane, false);
  test<2>("velocity, faces by value", Formulation::velocity, plane, false,
          BoundaryVelocityAs::value);
  test<2>("velocity, faces by balance", Formulation::velocity, plane, false,
          BoundaryVelocityAs::balance);
  test<2>("velocity, graded", Formulation::velocity, plane, false, BoundaryVelocityAs::automatic,
          true);
  test<2>("explicit pressure", Formulation::velocity_explicit_pressure, plane, false);
  test<2>("PISO", Formulation::velocity_pressure, plane, false);
  test<2>("PISO, axisymmetric", Formulation::velocity_pressure, Model::axisymmetric, false);
  test<2>("PISO, fluid beside solid", Formulation::velocity_pressure, plane, true);
  test<3>("PISO, three dimensions", Formulation::velocity_pressure, plane, false);
}
} // namespace test_of_segregated_solve
