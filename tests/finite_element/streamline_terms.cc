// The terms of SUPG: zero for solutions of the momentum equation, in axisymmetry too and on a mesh
// that has moved, and by hand for a residual that is constant.

#include <continua/finite_element/assembly/convective_terms.h>

#include <deal.II/base/mpi.h>

#include <cmath>

#include "../unit_test.h"
#include "powers_of_terms.h"
#include "small_problem.h"

namespace test_of_streamline_terms
{
using namespace Continua;
using namespace dealii;

namespace
{
template <int dim>
using VectorField = std::function<Tensor<1, dim>(const Point<dim> &)>;

/// The sum of test values times the rows of the stabilisation at a flow with the density 3 kg/m^3
/// and the viscosity 2 Pa s, in a step of 0.1 s. Of the places of a mesh that has moved by
/// `displacement` and moves on with `mesh_velocity`, if there is one.
template <int dim>
double power(const Space<dim> &space,
             const std::vector<Waveform> &body_force,
             const VectorField<dim> &velocity,
             const VectorField<dim> &acceleration,
             const std::function<double(const Point<dim> &)> &pressure,
             const VectorField<dim> &test,
             const double load_factor = 1.,
             const VectorField<dim> &displacement = {},
             const VectorField<dim> &mesh_velocity = {})
{
  Problem problem;
  problem.model = space.is_axisymmetric() ? Model::axisymmetric
                  : dim == 3              ? Model::three_dimensional
                                          : Model::plane_strain;
  problem.regions = {"liquid"};
  problem.materials.resize(1);
  problem.materials[0].density = 3.;
  problem.materials[0].shear.viscosity = 2.;
  problem.materials[0].compression = Compression::elastic(0.);
  problem.interior.body_force = body_force;
  problem.convection.is_on = true;
  problem.convection.stabilisation = ConvectionStabilisation::supg;
  problem.convection.stabilisation_viscosity = 1e-200; // grad-div comes with it
  problem.mesh_moves = static_cast<bool>(displacement);
  const auto place = [&](const Point<dim> &x)
  { return displacement ? Point<dim>(x + displacement(x)) : x; };
  const auto at_place = [&](const VectorField<dim> &field) -> VectorField<dim>
  { return [&](const Point<dim> &x) { return field(place(x)); }; };
  ConvectiveTerms<dim> terms(space, problem, std::nullopt);
  terms.reinit();
  StepSolution state;
  state.step = euler_step(0., 0.1, Update::implicit);
  state.step.load_factor = load_factor;
  state.velocity = small_problem::interpolated<dim>(space, at_place(velocity));
  state.acceleration = small_problem::interpolated<dim>(space, at_place(acceleration));
  state.pressure = small_problem::interpolated_pressure<dim>(
      space, [&](const Point<dim> &x, unsigned int) { return pressure(place(x)); });
  state.pressure_rate = space.pressure_vector();
  if (problem.mesh_moves)
  {
    state.mesh_displacement = small_problem::interpolated<dim>(space, displacement);
    state.mesh_velocity = small_problem::interpolated<dim>(space, mesh_velocity);
  }
  return powers_of(terms, state, small_problem::interpolated<dim>(space, test)).stabilisation;
}
} // namespace

UNIT_TEST(streamline_terms)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(mesh, {2, 2});
  Space<2> plane(mesh, SpaceParameters(), Model::plane_strain, 1);
  plane.distribute();
  small_problem::Mesh<2> round_mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(round_mesh, {2, 2}, Point<2>(0., 0.5));
  Space<2> ring(round_mesh, SpaceParameters(), Model::axisymmetric, 1);
  ring.distribute();
  small_problem::Mesh<3> solid_mesh(MPI_COMM_WORLD);
  small_problem::make_box<3>(solid_mesh, {1, 1, 1});
  Space<3> cube(solid_mesh, SpaceParameters(), Model::three_dimensional, 1);
  cube.distribute();
  const VectorField<2> rest = [](const Point<2> &) { return Tensor<1, 2>(); };
  const VectorField<2> test = [](const Point<2> &x) {
    return Tensor<1, 2>({x[0] + x[0] * x[1], x[1] * x[1] - x[0]});
  };
  const auto none = [](const Point<2> &) { return 0.; };

  // The flow between plates and in a pipe or ring: eta lap U = dp/dx.
  const VectorField<2> parabola = [](const Point<2> &x) {
    return Tensor<1, 2>({x[1] * (2. - x[1]), 0.});
  };
  const auto falling = [](const double slope)
  { return [slope](const Point<2> &x) { return slope * x[0]; }; };
  const double without_force = power<2>(plane, {}, parabola, rest, none, test);
  check::is_true("plates: a residual counts", std::abs(without_force) > 1e-2);
  check::absolute("plates: a solution",
                  power<2>(plane, {}, parabola, rest, falling(-4.), test) / without_force, 0.,
                  1e-12);
  check::absolute("plates: half of the force",
                  power<2>(plane, {Waveform(8.), Waveform(0.)}, parabola, rest, none, test, 0.5) /
                      without_force,
                  0., 1e-12);
  const VectorField<2> in_a_ring = [](const Point<2> &x) {
    return Tensor<1, 2>({3. - x[1] * x[1], 0.});
  };
  check::absolute("ring: a solution",
                  power<2>(ring, {}, in_a_ring, rest, falling(-8.), test) / without_force, 0.,
                  1e-12);
  // A flow along the radius that grows with r^2 has the force eta (3 + 1/3 3) of viscosity, and 2
  // r^3 of convection; along the axis nothing moves it.
  const VectorField<2> outwards = [](const Point<2> &x) { return Tensor<1, 2>({0., x[1] * x[1]}); };
  const std::vector<Waveform> holding = {Waveform(0.),
                                         Waveform(Expression("3*2*y*y*y - 2*4", Dimensions::none))};
  check::is_true("ring: a residual counts",
                 std::abs(power<2>(ring, {}, outwards, rest, none, test)) > 1e-2);
  check::absolute("ring: viscosity across",
                  power<2>(ring, holding, outwards, rest, none, test) / without_force, 0., 1e-12);
  // div U = r has a gradient that a force along the axis balances; U = (x r, 0): lap = x/r, grad
  // div = (0, 1), (U . grad) U = (x r^2, 0).
  const VectorField<2> sheared = [](const Point<2> &x) { return Tensor<1, 2>({x[0] * x[1], 0.}); };
  const std::vector<Waveform> shearing = {Waveform(Expression("3*x*y*y - 2*x/y", Dimensions::none)),
                                          Waveform(-2. / 3.)};
  check::absolute("ring: viscosity along",
                  power<2>(ring, shearing, sheared, rest, none, test) / without_force, 0., 1e-12);

  // On a mesh that was stretched and sheared, and moves.
  const VectorField<2> stretched = [](const Point<2> &x) {
    return Tensor<1, 2>({-0.1 * x[0] + 0.3 * x[1], 0.2 * x[1]});
  };
  const VectorField<2> moving = [](const Point<2> &x) { return Tensor<1, 2>({x[1], 0.4 * x[0]}); };
  // Past such a mesh a flow that is at rest in space changes: dU/dt at a node is (W . grad) U.
  const VectorField<2> of_parabola = [](const Point<2> &x)
  {
    const double across = 0.4 * (x[0] - 0.25 * x[1]) / 0.9;
    return Tensor<1, 2>({(2. - 2. * x[1]) * across, 0.});
  };
  check::absolute(
      "plates, moved mesh: a solution",
      power<2>(plane, {}, parabola, of_parabola, falling(-4.), test, 1., stretched, moving) /
          without_force,
      0., 1e-12);
  check::absolute("ring, moved mesh: viscosity across",
                  power<2>(ring, holding, outwards, rest, none, test, 1., stretched, rest) /
                      without_force,
                  0., 1e-11);
  // A linear flow has no viscous force, however curved the mesh is.
  const VectorField<2> curved = [](const Point<2> &x) {
    return Tensor<1, 2>({0.1 * x[0] * x[1], -0.2 * x[0] * x[0]});
  };
  const VectorField<2> shear = [](const Point<2> &x) { return Tensor<1, 2>({x[1], 0.}); };
  check::absolute("curved mesh: a solution",
                  power<2>(plane, {}, shear, rest, none, test, 1., curved, rest) / without_force,
                  0., 1e-12);

  // U = (2, 0, 0) accelerated by (0, 0, 5) in the pressure 7 y: r = (0, 7, 15), along v = (0, x, 3
  // x) with the derivative (0, 1, 3): 2 (7 + 45) tau over the cube of 1 m^3, in which h = 1 m.
  const double tau = 1. / std::sqrt(20. * 20. + 4. * 4. + 8. * 8.);
  check::relative("by hand",
                  power<3>(
                      cube, {},
                      [](const Point<3> &) {
                        return Tensor<1, 3>({2., 0., 0.});
                      },
                      [](const Point<3> &) {
                        return Tensor<1, 3>({0., 0., 5.});
                      },
                      [](const Point<3> &x) { return 7. * x[1]; },
                      [](const Point<3> &x) {
                        return Tensor<1, 3>({0., x[0], 3. * x[0]});
                      }),
                  2. * 52. * tau, 1e-12);
}
} // namespace test_of_streamline_terms
