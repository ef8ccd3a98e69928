// Powers and energies of linear fields by hand: kinetic, of springs, of a spring that relaxes, of
// viscosity, of the pressure, of loads and of walls that move; what is not balanced is left over.
// The ledger works on the operators of the cell-wise path.

#include <continua/continuum/ledger.h>
#include <continua/finite_volume/cell_wise.h>

#include "cell_wise_step.h"

#include "../unit_test.h"

#include <algorithm>

namespace test_of_cell_wise_ledger
{
namespace
{
using namespace cell_wise_meshes;
constexpr double density = 2., spring = 3., soft_spring = 4., relaxation_time = 0.2,
                 viscosity = 0.5, inverse_bulk_modulus = 0.25, pressure_value = 1.5;

/// Diagonal slopes of velocity and displacement; in axisymmetry the third is that round the axis.
using Slopes = std::array<double, 3>;

template <int dim>
VectorFunction<dim> field(const Slopes &slopes)
{
  return [slopes](const dealii::Point<dim> &p)
  {
    dealii::Tensor<1, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = slopes[c] * p[c];
    return result;
  };
}

/// 2 dev(a) : b.
double deviatoric(const Slopes &a, const Slopes &b)
{
  const double trace = a[0] + a[1] + a[2];
  double sum = 0.;
  for (unsigned int c = 0; c < 3; ++c)
    sum += 2. * (a[c] - trace / 3.) * b[c];
  return sum;
}

Slopes combined(const double factor, const Slopes &a, const double other_factor, const Slopes &b)
{
  Slopes result;
  for (unsigned int c = 0; c < 3; ++c)
    result[c] = factor * a[c] + other_factor * b[c];
  return result;
}

template <int dim>
void test(const Model model, const PowerOperator power_operator, const std::string &word)
{
  const bool axisymmetric = model == Model::axisymmetric;
  const std::string name = (axisymmetric ? "axisymmetric, "
                            : dim == 2   ? "2-D, "
                                         : "3-D, ") +
                           word + ": ";
  CellWiseParameters parameters;
  parameters.power_operator = power_operator;
  // Every boundary moves as it is told to; a body force of 3 N/m^3 along x.
  CellWiseStep<dim> step(
      [](Triangulation<dim> &mesh)
      {
        make_box(mesh, 4);
        grade(mesh);
      },
      model, make_coefficients(),
      [](Problem &problem)
      {
        Material &material = problem.materials[0];
        material.density = density;
        material.shear.viscosity = viscosity;
        material.compression = Compression::elastic(inverse_bulk_modulus);
        material.shear.branches = {Branch{spring, std::numeric_limits<double>::infinity()},
                                   Branch{soft_spring, relaxation_time}};
        problem.materials[1] = material;
        problem.interior.body_force.assign(dim, Waveform());
        problem.interior.body_force[0] = Waveform(3.);
        // So that nobody takes them for walls at rest.
        for (BoundaryCondition &condition : problem.conditions)
          condition.normal.vector.assign(dim, Waveform(1.));
      },
      parameters);
  const CellWiseSpace<dim> &space = step.space;
  const Problem &problem = step.problem;
  Log log(MPI_COMM_WORLD);
  CellWise<dim> body(step.triangulation, problem, parameters, log);
  body.setup();
  BranchHistory history(problem.materials);
  history.reinit(space.velocity_vector(), nodes_of_regions(space));
  BulkHistory bulk_history(problem.materials);
  bulk_history.reinit(space.pressure_vector(), std::vector<std::vector<unsigned int>>(2));
  OutletCoupling outlets(problem, body);
  outlets.build();
  Ledger ledger(problem, body, outlets, history, bulk_history);
  ledger.reinit();
  std::array<double, 2> volumes = {{0., 0.}};
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
    volumes[space.mesh.cells()[cell].material_id] += space.mesh.cells()[cell].volume;
  for (double &volume : volumes)
    volume = sum(volume);

  // A step of 0.1 s by Euler's rule.
  Slopes rate = {{0.2, -0.3, dim == 3 ? 0.4 : 0.}}, stretch = {{0.05, 0.02, dim == 3 ? -0.01 : 0.}};
  if (axisymmetric)
  {
    rate[2] = rate[1];
    stretch[2] = stretch[1];
  }
  history.displacement() = velocity_field<dim>(space, field<dim>(stretch));
  StepSolution solution;
  solution.step = euler_step(0., 0.1, Update::implicit);
  solution.velocity = velocity_field<dim>(space, field<dim>(rate));
  solution.pressure = pressure_field<dim>(space, [](const dealii::Point<dim> &, const unsigned int)
                                          { return pressure_value; });
  solution.acceleration = velocity_field<dim>(space,
                                              [](const dealii::Point<dim> &)
                                              {
                                                dealii::Tensor<1, dim> a;
                                                a[0] = 5.;
                                                return a;
                                              });
  solution.prescribed = space.velocity_vector();
  body.prescribed().prescribed_part(solution.velocity, solution.prescribed);
  history.advance(solution.step, solution.velocity, solution.velocity);

  // Uniform velocities of 1 m/s before and 2 m/s after, for the change of the kinetic energy.
  DistributedVector start = space.velocity_vector(), end = start;
  for (unsigned int i = 0; i < start.locally_owned_size(); i += dim)
  {
    start.begin()[i] = 1.;
    end.begin()[i] = 2.;
  }
  const PowerBalance balance = ledger.balance({solution, start, end}, true);

  const Slopes elastic = combined(1., stretch, 0.1, rate);
  const Slopes relaxing = combined(0.1 / (1. + 0.1 / relaxation_time), rate, 0., rate);
  const double dilatation = rate[0] + rate[1] + rate[2];
  // The centroid is where the cells' middle is in the mean, and with it that of the velocity.
  double mean_place = 0.;
  for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
    mean_place += space.mesh.cells()[cell].volume * space.mesh.cells()[cell].centre[0];
  const double volume = volumes[0] + volumes[1];
  check::relative(name + "centroid", sum(mean_place), 0.5 * volume, 1e-12);
  double kinetic = 0., others = 0.;
  for (unsigned int region = 0; region < 2; ++region)
  {
    const Power &power = balance.materials[region];
    const std::string of_region = name + (region == 0 ? "first, " : "second, ");
    // Within the regions the mean of x is not 1/2.
    double moment = 0.;
    for (unsigned int cell = 0; cell < space.mesh.n_owned_cells(); ++cell)
      if (space.mesh.cells()[cell].material_id == region)
        moment += space.mesh.cells()[cell].volume * space.mesh.cells()[cell].centre[0];
    const double expected_kinetic = power_operator == PowerOperator::scheme
                                        ? density * 5. * rate[0] * sum(moment)
                                        : 0.5 * density / 0.1 * (4. - 1.) * volumes[region];
    const double expected_strain = volumes[region] * (spring * deviatoric(elastic, rate) +
                                                      soft_spring * deviatoric(relaxing, rate));
    const double expected_viscous = volumes[region] * viscosity * deviatoric(rate, rate);
    const double expected_compressive = -volumes[region] * pressure_value * dilatation;
    check::relative(of_region + "kinetic", power.terms[0], expected_kinetic, 1e-12);
    check::relative(of_region + "strain", power.terms[1], expected_strain, 1e-12);
    check::relative(of_region + "viscous", power.terms[2], expected_viscous, 1e-12);
    check::relative(of_region + "compressive", power.terms[3], expected_compressive, 1e-12);
    check::relative(
        of_region + "relaxation", power.relaxation,
        volumes[region] * soft_spring / relaxation_time * deviatoric(relaxing, relaxing), 1e-12);
    kinetic += expected_kinetic;
    others += expected_strain + expected_viscous + expected_compressive;
  }
  // The walls give what stress and pressure take.
  const double weight = 3. * rate[0] * 0.5 * volume;
  check::relative(name + "external", balance.external, weight + others, 1e-12);
  check::relative(name + "left over", balance.residual, weight - kinetic, 1e-12);
  check::relative(name + "time", balance.time, 0.1, 1e-14);

  const State state{end, solution.pressure, history};
  const Energy energy = ledger.energy(state);
  check::relative(name + "kinetic energy", energy.of_term(0), 0.5 * density * 4. * volume, 1e-12);
  check::relative(
      name + "energy of springs", energy.of_term(1),
      0.5 * volume *
          (spring * deviatoric(elastic, elastic) + soft_spring * deviatoric(relaxing, relaxing)),
      1e-12);
  check::relative(name + "energy of the pressure", energy.of_term(3),
                  0.5 * inverse_bulk_modulus * pressure_value * pressure_value * volume, 1e-12);
  check::relative(name + "of the second material", energy.terms[3][1],
                  energy.of_term(3) * volumes[1] / volume, 1e-12);
}
} // namespace

UNIT_TEST(cell_wise_ledger)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  quiet_other_ranks();
  test<2>(Model::plane_strain, PowerOperator::scheme, "scheme");
  test<2>(Model::axisymmetric, PowerOperator::scheme, "scheme");
  test<2>(Model::plane_strain, PowerOperator::compact, "compact");
  test<2>(Model::axisymmetric, PowerOperator::wide, "wide");
  test<3>(Model::three_dimensional, PowerOperator::scheme, "scheme");
}
} // namespace test_of_cell_wise_ledger
