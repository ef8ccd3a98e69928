// Powers and energies of linear fields by hand: kinetic, of springs, of a spring that relaxes, of
// viscosity, of the pressure, of loads and of walls that move; what is not balanced is left over.
// The ledger works on the operators of the finite elements.

#include <continua/continuum/ledger.h>
#include <continua/finite_element/taylor_hood.h>

#include "small_problem.h"

#include "../unit_test.h"

#include <limits>

namespace test_of_ledger
{
namespace
{
using namespace Continua;
using namespace dealii;
constexpr double density = 2., spring = 3., soft_spring = 4., relaxation_time = 0.2,
                 viscosity = 0.5, inverse_bulk_modulus = 0.25, pressure_value = 1.5;

/// Diagonal slopes of velocity and displacement; in axisymmetry the third is that round the axis.
using Slopes = std::array<double, 3>;

/// 2 dev(a) : b.
double deviatoric(const Slopes &a, const Slopes &b)
{
  const double trace = a[0] + a[1] + a[2];
  double sum = 0.;
  for (unsigned int c = 0; c < 3; ++c)
    sum += 2. * (a[c] - trace / 3.) * b[c];
  return sum;
}

/// A body 2 m long and 1 m wide (1 m thick; in axisymmetry from the axis on), half of each region,
/// of the same material. `walls_move`: every boundary moves as it is told to, without acceleration
/// or weight, so that the walls give what stress and pressure take; else all are free.
template <int dim>
void test(const Model model, const bool walls_move)
{
  const bool axisymmetric = model == Model::axisymmetric;
  const std::string name = std::string(axisymmetric ? "axisymmetric"
                                       : dim == 2   ? "2-D"
                                                    : "3-D") +
                           (walls_move ? ": " : ", free: ");
  Problem problem;
  problem.model = model;
  problem.regions = {"one", "two"};
  Material material;
  material.density = density;
  material.shear.viscosity = viscosity;
  material.compression = Compression::elastic(inverse_bulk_modulus);
  material.shear.branches = {Branch{spring, std::numeric_limits<double>::infinity()},
                             Branch{soft_spring, relaxation_time}};
  problem.materials = {material, material};
  for (unsigned int b = 0; b < 2 * dim; ++b)
  {
    BoundaryCondition condition;
    condition.name = "boundary " + std::to_string(b);
    condition.boundary_id = b;
    condition.region_ids = {0, 1};
    if (walls_move)
    {
      condition.normal.kind = condition.tangential.kind = BoundaryPart::Kind::velocity;
      // So that nobody takes it for a body with walls at rest.
      condition.normal.vector.assign(dim, Waveform(1.));
      condition.tangential.vector.assign(dim, Waveform(1.));
    }
    problem.boundaries.push_back(condition.name);
    problem.conditions.push_back(condition);
  }
  const double acceleration = walls_move ? 0. : 5., body_force = walls_move ? 0. : 3.;
  problem.interior.body_force.assign(dim, Waveform());
  problem.interior.body_force[0] = Waveform(body_force);

  small_problem::Mesh<dim> mesh(MPI_COMM_WORLD);
  std::vector<unsigned int> cells(dim, 1);
  cells[0] = 2;
  small_problem::make_box<dim>(mesh, cells, Point<dim>(), 1.);
  small_problem::refine<dim>(mesh, [](const Point<dim> &x) { return x[0] > 1.; });
  Log log(MPI_COMM_WORLD);
  TaylorHood<dim> body(mesh, problem, TaylorHoodParameters(), log);
  body.setup();
  Space<dim> space(mesh, SpaceParameters(), model, 2);
  space.distribute();
  BranchHistory history(problem.materials);
  history.reinit(body.velocity_vector(), body.velocity_nodes());
  BulkHistory bulk_history(problem.materials);
  bulk_history.reinit(body.pressure_vector(), std::vector<std::vector<unsigned int>>(2));
  OutletCoupling outlets(problem, body);
  outlets.initialise();
  outlets.build();
  Ledger ledger(problem, body, outlets, history, bulk_history);
  ledger.reinit();

  // A step of 0.1 s by Euler's rule.
  Slopes rate = {{0.2, -0.3, dim == 3 ? 0.4 : 0.}}, stretch = {{0.05, 0.02, dim == 3 ? -0.01 : 0.}};
  if (axisymmetric)
  {
    rate[2] = rate[1];
    stretch[2] = stretch[1];
  }
  const auto field = [&](const Slopes &slopes)
  {
    return small_problem::interpolated<dim>(space,
                                            [&](const Point<dim> &p)
                                            {
                                              Tensor<1, dim> u;
                                              for (unsigned int c = 0; c < dim; ++c)
                                                u[c] = slopes[c] * p[c];
                                              return u;
                                            });
  };
  const auto uniform = [&](const double value)
  {
    return small_problem::interpolated<dim>(space,
                                            [value](const Point<dim> &)
                                            {
                                              Tensor<1, dim> u;
                                              u[0] = value;
                                              return u;
                                            });
  };
  history.displacement() = field(stretch);
  StepSolution solution;
  solution.step = euler_step(0., 0.1, Update::implicit);
  solution.velocity = field(rate);
  solution.pressure = small_problem::interpolated_pressure<dim>(
      space, [](const Point<dim> &, const unsigned int) { return pressure_value; });
  solution.acceleration = uniform(acceleration);
  solution.prescribed = space.velocity_vector();
  body.prescribed().prescribed_part(solution.velocity, solution.prescribed);
  history.advance(solution.step, solution.velocity, solution.velocity);
  const PowerBalance balance =
      ledger.balance({solution, solution.velocity, solution.velocity}, true);

  Slopes elastic, relaxing;
  for (unsigned int c = 0; c < 3; ++c)
  {
    elastic[c] = stretch[c] + 0.1 * rate[c];
    relaxing[c] = 0.1 * rate[c] / (1. + 0.1 / relaxation_time);
  }
  const double half = axisymmetric ? numbers::PI : 1.;
  const double dilatation = rate[0] + rate[1] + rate[2];
  double kinetic = 0., others = 0.;
  for (unsigned int region = 0; region < 2; ++region)
  {
    const Power &power = balance.materials[region];
    const std::string of_region = name + (region == 0 ? "first, " : "second, ");
    const double expected_kinetic = density * acceleration * rate[0] * (0.5 + region) * half;
    const double expected_strain =
        half * (spring * deviatoric(elastic, rate) + soft_spring * deviatoric(relaxing, rate));
    const double expected_viscous = half * viscosity * deviatoric(rate, rate);
    const double expected_compressive = -half * pressure_value * dilatation;
    check::absolute(of_region + "kinetic", power.terms[0], expected_kinetic, 1e-12);
    check::relative(of_region + "strain", power.terms[1], expected_strain, 1e-12);
    check::relative(of_region + "viscous", power.terms[2], expected_viscous, 1e-12);
    check::relative(of_region + "compressive", power.terms[3], expected_compressive, 1e-12);
    check::relative(of_region + "relaxation", power.relaxation,
                    half * soft_spring / relaxation_time * deviatoric(relaxing, relaxing), 1e-12);
    kinetic += expected_kinetic;
    others += expected_strain + expected_viscous + expected_compressive;
  }
  const double external = body_force * rate[0] * 1. * 2. * half + (walls_move ? others : 0.);
  check::relative(name + "external", balance.external, external, 1e-12);
  check::absolute(name + "left over", balance.residual, external - kinetic - others, 1e-12);
  check::relative(name + "time", balance.time, 0.1, 1e-14);

  // All at 2 m/s.
  const DistributedVector moving = uniform(2.);
  const auto check_energy = [&](const std::string &of_ledger, Ledger &its)
  {
    const Energy energy = its.energy(State{moving, solution.pressure, history});
    check::relative(of_ledger + "kinetic energy", energy.of_term(0), 0.5 * density * 4. * 2. * half,
                    1e-12);
    check::relative(
        of_ledger + "energy of springs", energy.of_term(1),
        0.5 * 2. * half *
            (spring * deviatoric(elastic, elastic) + soft_spring * deviatoric(relaxing, relaxing)),
        1e-12);
    check::relative(of_ledger + "energy of the pressure", energy.of_term(3),
                    0.5 * inverse_bulk_modulus * pressure_value * pressure_value * 2. * half,
                    1e-12);
    check::relative(of_ledger + "of the second material", energy.terms[1][1],
                    0.5 * energy.of_term(1), 1e-12);
  };
  check_energy(name, ledger);
  // As a run has it.
  LevelProducts products(problem, body, history, moving, moving);
  products.reinit();
  Ledger with_products(problem, body, outlets, history, bulk_history, &products);
  with_products.reinit();
  check_energy(name + "with products, ", with_products);
}
} // namespace

UNIT_TEST(ledger)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::quiet_other_ranks();
  test<2>(Model::plane_strain, true);
  test<2>(Model::plane_strain, false);
  test<2>(Model::axisymmetric, true);
  test<3>(Model::three_dimensional, false);
}
} // namespace test_of_ledger
