// The convective terms: forces of polynomial flows by hand, the derivative against differences, the
// power of the skew form, of a compressible liquid too, inflow at open ends, and regions that have
// none; on hanging nodes, in axisymmetry and in space.

#include <continua/finite_element/assembly/convective_terms.h>

#include <deal.II/base/mpi.h>

#include <cmath>

#include "../unit_test.h"
#include "flow_state.h"
#include "powers_of_terms.h"

namespace test_of_convective_terms
{
using namespace Continua;
using namespace dealii;
using flow_state::make_state;
using flow_state::wave;

namespace
{
/// A liquid in region 0 and a solid in region 1.
Problem make_problem(const Model model, const double inverse_bulk_modulus, const double exponent)
{
  Problem problem;
  problem.model = model;
  problem.regions = {"liquid", "solid"};
  problem.materials.resize(2);
  problem.materials[0].density = 3.;
  problem.materials[0].compression = Compression::elastic(inverse_bulk_modulus);
  problem.materials[0].volume_exponent = exponent;
  problem.materials[0].reference_pressure = 0.3;
  problem.materials[1] = problem.materials[0];
  problem.materials[1].shear.branches = {{1., 1.}};
  problem.convection.is_on = true;
  problem.convection.stabilisation_viscosity = 0.7;
  return problem;
}

/// An open end on the left where liquid flows in with the total pressure.
void add_open_end(Problem &problem)
{
  BoundaryCondition condition;
  condition.boundary_id = 0;
  condition.region_ids = {0};
  condition.inflow_pressure = InflowPressure::total;
  problem.conditions.push_back(condition);
}

/// The rows of momentum and of the negative of volume, one after the other.
template <int dim>
std::vector<double>
rows_of(const Space<dim> &space, ConvectiveTerms<dim> &terms, const StepSolution &state)
{
  DistributedVector momentum = space.velocity_vector(), volume = space.pressure_vector();
  terms.add(state, momentum, volume);
  std::vector<double> rows(momentum.begin(), momentum.end());
  for (unsigned int k = 0; k < volume.locally_owned_size(); ++k)
    rows.push_back(-volume.begin()[k]);
  return rows;
}

/// state + factor times a change, with the rates that follow.
template <int dim>
StepSolution
changed(const StepSolution &state, const std::vector<double> &change, const double factor)
{
  StepSolution result = state;
  const unsigned int n_velocity = state.velocity.locally_owned_size();
  for (unsigned int i = 0; i < n_velocity; ++i)
  {
    result.velocity.begin()[i] += factor * change[i];
    result.acceleration.begin()[i] += factor * state.step.a0 * change[i];
  }
  for (unsigned int k = 0; k < state.pressure.locally_owned_size(); ++k)
  {
    result.pressure.begin()[k] += factor * change[n_velocity + k];
    result.pressure_rate.begin()[k] += factor / state.step.pressure_time * change[n_velocity + k];
  }
  return result;
}

template <int dim>
void check_derivative(const std::string &name,
                      const Space<dim> &space,
                      const ConvectiveTerm term,
                      const double exponent,
                      const ConvectionStabilisation stabilisation,
                      const double viscosity)
{
  Problem problem = make_problem(
      space.is_axisymmetric() ? Model::axisymmetric : Model::plane_strain, 0.05, exponent);
  problem.convection.term = term;
  problem.materials[0].shear.viscosity = 2.;
  problem.convection.stabilisation = stabilisation;
  problem.convection.stabilisation_viscosity = viscosity;
  if (stabilisation == ConvectionStabilisation::supg)
    problem.interior.body_force = {Waveform(0.4), Waveform(-0.9)};
  else
    problem.materials[0].shear.flow_curve = FlowCurve{2., 0.3, 0.8, 0.4, 1.5};
  add_open_end(problem);
  ConvectiveTerms<dim> terms(space, problem, std::nullopt);
  terms.reinit();
  const StepSolution state = make_state(space);
  // Any change, nothing at hanging nodes.
  DistributedVector velocity = small_problem::interpolated<dim>(
      space,
      [](const Point<dim> &x) { return wave(x, 7.) * Point<dim>::unit_vector(dim - 1) + 0.3 * x; });
  DistributedVector pressure = small_problem::interpolated_pressure<dim>(
      space, [](const Point<dim> &x, unsigned int) { return wave(x, 9.); });
  std::vector<double> change(velocity.begin(), velocity.end());
  change.insert(change.end(), pressure.begin(), pressure.end());

  const double h = 1e-5;
  const std::vector<double> above = rows_of(space, terms, changed<dim>(state, change, h)),
                            below = rows_of(space, terms, changed<dim>(state, change, -h));
  EntrySums sums;
  sums.begin(static_cast<int>(change.size()));
  terms.add_derivative(state, space.velocity_hanging, sums);
  sums.finish();
  const Triplets &matrix = sums.matrix();
  std::vector<double> product(change.size(), 0.);
  for (std::size_t k = 0; k < matrix.values.size(); ++k)
    product[matrix.rows[k]] += matrix.values[k] * change[matrix.columns[k]];
  // The same product with the matrices of the cells.
  DistributedVector momentum = space.velocity_vector(), volume = space.pressure_vector();
  terms.keep_derivative(state);
  terms.add_derivative_product(velocity, pressure, momentum, volume);
  std::vector<double> kept(momentum.begin(), momentum.end());
  for (unsigned int k = 0; k < volume.locally_owned_size(); ++k)
    kept.push_back(-volume.begin()[k]);
  double largest = 0., difference = 0., between = 0.;
  for (std::size_t i = 0; i < product.size(); ++i)
  {
    largest = std::max(largest, std::abs(product[i]));
    between = std::max(between, std::abs(product[i] - kept[i]));
    difference = std::max(difference, std::abs(product[i] - (above[i] - below[i]) / (2. * h)));
  }
  check::is_true(name + ": there is a derivative", largest > 0.1);
  check::absolute(name + ": derivative", difference / largest, 0., 1e-8);
  check::absolute(name + ": kept derivative", between / largest, 0., 1e-13);
}

/// A flow that is zero at the boundary of the square of side 2.
template <int dim>
DistributedVector enclosed_flow(const Space<dim> &space)
{
  return small_problem::interpolated<dim>(space,
                                          [](const Point<dim> &x)
                                          {
                                            double bump = 1.;
                                            for (unsigned int c = 0; c < dim; ++c)
                                              bump *= x[c] * (2. - x[c]);
                                            Tensor<1, dim> value;
                                            for (unsigned int c = 0; c < dim; ++c)
                                              value[c] = bump * wave(x, 2. * c);
                                            return value;
                                          });
}

/// The power of convection in a flow that is zero at the boundary of the liquid.
template <int dim>
double power_of_enclosed_flow(const Space<dim> &space, const ConvectiveTerm term)
{
  Problem problem = make_problem(Model::plane_strain, 0., 0.);
  problem.convection.term = term;
  problem.convection.stabilisation = ConvectionStabilisation::none;
  ConvectiveTerms<dim> terms(space, problem, std::nullopt);
  terms.reinit();
  StepSolution state = make_state(space);
  state.velocity = enclosed_flow(space);
  return powers_of(terms, state, state.velocity).convection;
}

/// The rate of the kinetic energy in an enclosed flow, by differences along the rates of the state.
template <int dim>
double
rate_of_kinetic_energy(const Space<dim> &space, const Problem &problem, const StepSolution &state)
{
  ConvectiveTerms<dim> terms(space, problem, std::nullopt);
  terms.reinit();
  const BranchHistory history(problem.materials);
  const double h = 1e-5;
  const auto energy_at = [&](const double time)
  {
    DistributedVector velocity = state.velocity, pressure = state.pressure;
    velocity.add(time, state.acceleration);
    pressure.add(time, state.pressure_rate);
    return terms.energy_of(0, {velocity, pressure, history}).kinetic;
  };
  return (energy_at(h) - energy_at(-h)) / (2. * h);
}
} // namespace

UNIT_TEST(convective_terms)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(mesh, {4, 2}, Point<2>(), 2.);
  small_problem::refine<2>(mesh, [](const Point<2> &x) { return x[0] < 1. || x[1] > 1.; });
  Space<2> space(mesh, SpaceParameters(), Model::plane_strain, 2);
  space.distribute();
  small_problem::Mesh<2> round_mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(round_mesh, {2, 2}, Point<2>(0., 0.5), 1.);
  Space<2> round_space(round_mesh, SpaceParameters(), Model::axisymmetric, 2);
  round_space.distribute();
  small_problem::Mesh<3> solid_mesh(MPI_COMM_WORLD);
  small_problem::make_box<3>(solid_mesh, {2, 1, 1}, Point<3>(), 1.);
  Space<3> solid_space(solid_mesh, SpaceParameters(), Model::three_dimensional, 2);
  solid_space.distribute();

  for (const ConvectiveTerm term : {ConvectiveTerm::skew, ConvectiveTerm::advective})
    for (const double exponent : {0., 1., 7.15})
    {
      const std::string name = std::string(term == ConvectiveTerm::skew ? "skew" : "advective") +
                               ", exponent " + std::to_string(exponent);
      for (const ConvectionStabilisation stabilisation :
           {ConvectionStabilisation::grad_div, ConvectionStabilisation::supg})
      {
        const bool is_supg = stabilisation == ConvectionStabilisation::supg;
        const std::string with = is_supg ? name + ", supg" : name;
        // Given, and by itself.
        const double viscosity = is_supg ? 0. : 0.7;
        check_derivative(with + ", plane", space, term, exponent, stabilisation, viscosity);
        check_derivative(with + ", axisymmetric", round_space, term, exponent, stabilisation,
                         viscosity);
        check_derivative(with + ", in space", solid_space, term, exponent, stabilisation,
                         viscosity);
      }
    }

  // In the square of the liquid, with the solid's region beside it at rest.
  small_problem::Mesh<2> square(MPI_COMM_WORLD);
  small_problem::make_box<2>(square, {2, 2});
  small_problem::refine<2>(square, [](const Point<2> &x) { return x[0] < 1.; });
  Space<2> square_space(square, SpaceParameters(), Model::plane_strain, 2);
  square_space.distribute();
  const double advective = power_of_enclosed_flow(square_space, ConvectiveTerm::advective);
  check::is_true("the advective form has a power", std::abs(advective) > 1e-3);
  check::absolute("the skew form has none",
                  power_of_enclosed_flow(square_space, ConvectiveTerm::skew) / advective, 0.,
                  1e-11);

  // With a density that follows the pressure, the power of inertia and of the skew form is the rate
  // of the kinetic energy: exact for the exponent 1, whose density is a polynomial.
  {
    Problem gas = make_problem(Model::plane_strain, 0.05, 1.);
    StepSolution moving = make_state(square_space);
    moving.velocity = enclosed_flow(square_space);
    ConvectiveTerms<2> terms(square_space, gas, std::nullopt);
    terms.reinit();
    const NonlinearPowers powers = powers_of(terms, moving, moving.velocity);
    const double of_constant_density =
        rate_of_kinetic_energy<2>(square_space, make_problem(Model::plane_strain, 0., 0.), moving);
    const double rate = rate_of_kinetic_energy<2>(square_space, gas, moving);
    const double power = powers.inertia + powers.convection;
    check::is_true("kinetic energy: the density counts",
                   std::abs(rate / of_constant_density - 1.) > 1e-3);
    check::absolute("kinetic energy: its rate is the power", power / rate, 1., 1e-8);
    check::is_true("grad-div has a power of its own", std::abs(powers.stabilisation) > 1e-3);
  }

  // U = (x, r), p = 3 r in the ring of 1 m between r = 0.5 m and 2.5 m: (U . grad) U = U, div U =
  // 3, U . grad p = 3 r.
  {
    Problem ring = make_problem(Model::axisymmetric, 0., 0.);
    StepSolution moving = make_state(round_space);
    moving.acceleration = 0.;
    moving.pressure_rate = 0.;
    moving.velocity = small_problem::interpolated<2>(round_space,
                                                     [](const Point<2> &x) {
                                                       return Tensor<1, 2>({x[0], x[1]});
                                                     });
    moving.pressure = small_problem::interpolated_pressure<2>(
        round_space, [](const Point<2> &x, unsigned int) { return 3. * x[1]; });
    const DistributedVector along = small_problem::interpolated<2>(round_space,
                                                                   [](const Point<2> &) {
                                                                     return Tensor<1, 2>({1., 0.});
                                                                   });
    ConvectiveTerms<2> of_liquid(round_space, ring, std::nullopt);
    of_liquid.reinit();
    // int 2 pi r dr dx = 6 pi m^3, its mean of x is 1/2.
    check::relative("ring: convection, skew", powers_of(of_liquid, moving, along).convection,
                    3. * (1. + 1.5) * 0.5 * 6. * numbers::PI, 1e-12);
    check::relative("ring: grad-div", powers_of(of_liquid, moving, moving.velocity).stabilisation,
                    0.7 * 9. * 6. * numbers::PI, 1e-12);
    check::relative("ring: the given viscosity of grad-div in a cell",
                    of_liquid.grad_div_viscosities(moving)[2], 0.7, 1e-12);
    // Its factor by itself, 0.15 times density, the speed 2 m/s of this flow and the side of a
    // cell, 1 m.
    ring.convection.stabilisation_viscosity = 0.;
    StepSolution outward = moving;
    outward.velocity = small_problem::interpolated<2>(round_space,
                                                      [](const Point<2> &) {
                                                        return Tensor<1, 2>({0., 2.});
                                                      });
    // div U = 2/r: int (2/r)^2 2 pi r dr dx = 8 pi ln 5; four points along the radius are not
    // exact.
    check::relative("ring: grad-div by itself",
                    powers_of(of_liquid, outward, outward.velocity).stabilisation,
                    0.15 * 3. * 2. * 8. * numbers::PI * std::log(5.), 1e-3);
    check::relative("ring: the viscosity of grad-div in a cell by itself",
                    of_liquid.grad_div_viscosities(outward)[2], 0.15 * 3. * 2., 1e-12);
    outward.velocity = small_problem::interpolated<2>(round_space,
                                                      [](const Point<2> &x) {
                                                        return Tensor<1, 2>({x[1], 0.});
                                                      });
    // The mean of r between 0.5 and 1.5 m: int r^2 dr / int r dr = (3.375 - 0.125) / 3.
    check::relative("ring: the mean in a cell by the circumference",
                    of_liquid.grad_div_viscosities(outward)[0], 0.15 * 3. * 3.25 / 3., 1e-12);
    ring.convection.stabilisation = ConvectionStabilisation::none;
    check::is_true("ring: none without a stabilisation",
                   of_liquid.grad_div_viscosities(outward).empty());
    ring.convection.stabilisation = ConvectionStabilisation::grad_div;
    ring = make_problem(Model::axisymmetric, 0.5, 0.);
    ConvectiveTerms<2> of_gas(round_space, ring, std::nullopt);
    of_gas.reinit();
    DistributedVector momentum = round_space.velocity_vector(),
                      volume = round_space.pressure_vector();
    of_gas.add(moving, momentum, volume);
    check::relative("ring: volume", volume.mean_value() * volume.size(),
                    0.5 * 3. * 2. * numbers::PI * (15.625 - 0.125) / 3. + 3. * 6. * numbers::PI,
                    1e-12);
    // The pressure takes -int p div U = -3 int 3 r 2 pi r dr.
    check::relative("ring: power of the pressure",
                    powers_of(of_gas, moving, moving.velocity).compression,
                    -9. * 2. * numbers::PI * (15.625 - 0.125) / 3., 1e-12);
    // And inertia 3 kg/m^3 times the acceleration 1 along x.
    moving.pressure = 0.;
    moving.acceleration = along;
    check::relative("ring: inertia", powers_of(of_gas, moving, along).inertia,
                    3. * std::exp(-0.5 * 0.3) * 6. * numbers::PI, 1e-12);
  }

  // Simple shear U = (3 y, 0) of the rate 3: the power is eta(3) 9 over the area 4; and
  // U = (-2 x, r) of a ring, whose strain rate (-2, 1, 1) has the rate sqrt(12).
  {
    const FlowCurve curve{2., 0.3, 0.8, 0.4, 1.5};
    const auto power_in =
        [&](const Space<2> &of_space, const Model model, const Tensor<2, 2> &gradient)
    {
      Problem thinning = make_problem(model, 0., 0.);
      thinning.materials[0].shear.viscosity = 2.;
      thinning.materials[0].shear.flow_curve = curve;
      StepSolution moving = make_state(of_space);
      moving.velocity = small_problem::interpolated<2>(of_space, [&](const Point<2> &x)
                                                       { return gradient * Tensor<1, 2>(x); });
      ConvectiveTerms<2> terms(of_space, thinning, std::nullopt);
      terms.reinit();
      return powers_of(terms, moving, moving.velocity).viscosity;
    };
    Tensor<2, 2> shear, stretch;
    shear[0][1] = 3.;
    stretch[0][0] = -2.;
    stretch[1][1] = 1.;
    check::relative("thinning: shear", power_in(square_space, Model::plane_strain, shear),
                    curve.viscosity(3.) * 9. * 4., 1e-12);
    check::relative("thinning: stretched ring", power_in(round_space, Model::axisymmetric, stretch),
                    curve.viscosity(std::sqrt(12.)) * 12. * 6. * numbers::PI, 1e-12);
  }

  // U = (1 + x, 1) enters at x = 0 over the height 2: t = rho/2 (-1) U.
  {
    Problem open = make_problem(Model::plane_strain, 0., 0.);
    add_open_end(open);
    StepSolution moving = make_state(square_space);
    moving.velocity = small_problem::interpolated<2>(square_space,
                                                     [](const Point<2> &x) {
                                                       return Tensor<1, 2>({1. + x[0], 1.});
                                                     });
    for (const double direction : {1., -1.})
    {
      moving.velocity *= direction;
      ConvectiveTerms<2> terms(square_space, open, std::nullopt);
      terms.reinit();
      const double power = powers_of(terms, moving, moving.velocity).inflow;
      check::absolute(direction > 0. ? "inflow: its energy is taken" : "outflow: nothing", power,
                      direction > 0. ? 0.5 * 3. * 2. * 2. : 0., 1e-12);
    }
  }

  // U = (x, 0), p = 3 x: (U . grad) U = (x, 0), U . grad p = 3 x, div U = 1, over the square of
  // side 2.
  Problem problem = make_problem(Model::plane_strain, 0.5, 0.);
  problem.materials[0].reference_pressure = 0.;
  problem.convection.stabilisation = ConvectionStabilisation::none;
  problem.convection.term = ConvectiveTerm::advective;
  StepSolution state = make_state(square_space);
  state.velocity = small_problem::interpolated<2>(square_space,
                                                  [](const Point<2> &x) {
                                                    return Tensor<1, 2>({x[0], 0.});
                                                  });
  state.pressure = small_problem::interpolated_pressure<2>(
      square_space, [](const Point<2> &x, unsigned int) { return 3. * x[0]; });
  state.acceleration = 0.;
  state.pressure_rate = 0.;
  const DistributedVector along = small_problem::interpolated<2>(square_space,
                                                                 [](const Point<2> &) {
                                                                   return Tensor<1, 2>({1., 0.});
                                                                 });
  for (const bool is_skew : {false, true})
  {
    problem.convection.term = is_skew ? ConvectiveTerm::skew : ConvectiveTerm::advective;
    ConvectiveTerms<2> terms(square_space, problem, std::nullopt);
    terms.reinit();
    DistributedVector momentum = square_space.velocity_vector(),
                      volume = square_space.pressure_vector();
    terms.add(state, momentum, volume);
    // rho = 3 exp(1.5 x), c = 1/2, m = 1.5 x + 1: integrals over x times the side.
    const double e = std::exp(3.);
    const double of_x = 2. * 3. * (e * (2. / 1.5 - 1. / 2.25) + 1. / 2.25);
    const double of_x_squared = 2. * 3. * (e * (4. / 1.5 - 4. / 2.25 + 2. / 3.375) - 2. / 3.375);
    const double expected = is_skew ? 1.5 * of_x + 0.75 * of_x_squared : of_x;
    check::relative(is_skew ? "momentum, skew" : "momentum, advective", momentum * along, expected,
                    1e-5);
    // With div U = 1 over the area 4.
    check::relative("volume", volume.mean_value() * volume.size(), 2. * 0.5 * 3. * 2. + 4., 1e-12);
  }

  // A solid has no such terms.
  problem = make_problem(Model::plane_strain, 0.05, 1.);
  ConvectiveTerms<2> terms(space, problem, std::nullopt);
  terms.reinit();
  state = make_state(space);
  check::absolute("in the solid", forces_of(terms, state, 1).linfty_norm(), 0., 0.);
  check::is_true("in the liquid", forces_of(terms, state, 0).linfty_norm() > 0.1);

  // With hanging nodes, and with an end through which the liquid enters.
  for (const Space<2> *const of_liquid : {&space, &round_space})
  {
    const bool is_round = of_liquid->is_axisymmetric();
    Problem open = make_problem(is_round ? Model::axisymmetric : Model::plane_strain, 0.05, 1.);
    add_open_end(open);
    ConvectiveTerms<2> open_terms(*of_liquid, open, std::nullopt);
    open_terms.reinit();
    check_powers(is_round ? "axisymmetric" : "hanging nodes", open_terms, make_state(*of_liquid),
                 small_problem::interpolated<2>(*of_liquid,
                                                [](const Point<2> &x) {
                                                  return Tensor<1, 2>({1. + x[0] * x[1], x[1]});
                                                }));
  }
}
} // namespace test_of_convective_terms
