// Solids in finite deformation: the derivative against differences in all models, laws and schemes;
// a rigid rotation, a homogeneous stretch by hand, the power of stress against the rate of the
// energy, and the pressures, given and of a cavity, that follow a turned body, and body forces that
// depend on the place; branches that relax;
// on hanging nodes, in axisymmetry and in space.

#include <continua/finite_element/assembly/deformation_terms.h>

#include <continua/base/input_error.h>
#include <continua/continuum/state_vectors.h>
#include <continua/materials/strain_law_types.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>

#include "../unit_test.h"
#include "powers_of_terms.h"
#include "small_problem.h"

namespace test_of_deformation_terms
{
using namespace Continua;
using namespace dealii;

namespace
{
Problem make_problem(const Model model, const std::string &law, const double viscosity)
{
  Problem problem;
  problem.model = model;
  problem.deformation = Deformation::finite;
  problem.regions = {"body"};
  problem.materials.resize(1);
  Material &material = problem.materials[0];
  material.density = 3.;
  material.compression = Compression::elastic(1. / 7.);
  material.shear.branches = {{2., std::numeric_limits<double>::infinity()}};
  material.shear.viscosity = viscosity;
  StrainLawParameters &parameters = material.strain_law_parameters;
  parameters.type = law;
  parameters.mooney_rivlin_share = 0.3;
  parameters.fibre_stiffness = 1.5;
  parameters.fibre_exponent = 0.7;
  parameters.fibre_dispersion = 0.1;
  parameters.fibre_angle = 0.6;
  material.strain_law = make_strain_law(parameters, 2., 7.);
  return problem;
}

/// Two branches that relax beside the spring.
void add_branches(Problem &problem)
{
  problem.materials[0].shear.branches.push_back({1.2, 0.5});
  problem.materials[0].shear.branches.push_back({0.7, 0.1});
}

/// A cavity below.
void add_cavity(Problem &problem)
{
  BoundaryCondition condition;
  condition.type = BoundaryType::cavity;
  condition.boundary_id = 2;
  condition.region_ids = {0};
  problem.conditions.push_back(condition);
}

/// A pressure on the left, which grows with y.
void add_pressure(Problem &problem)
{
  BoundaryCondition condition;
  condition.type = BoundaryType::pressure;
  condition.boundary_id = 0;
  condition.region_ids = {0};
  condition.normal.negative = true;
  condition.normal.along_normal = Waveform(Expression("1.7 + 0.4*y", Dimensions::none));
  problem.conditions.push_back(condition);
}

/// One that depends on the place.
template <int dim>
void add_body_force(Problem &problem)
{
  for (unsigned int c = 0; c < dim; ++c)
    problem.interior.body_force.emplace_back(Expression("0.8*x*y - 0.3*y*y", Dimensions::none));
}

template <int dim>
double wave(const Point<dim> &x, const double phase)
{
  double sum = phase;
  for (unsigned int c = 0; c < dim; ++c)
    sum += (0.9 + 0.4 * c + 0.2 * phase) * x[c];
  return std::sin(sum);
}

double displacement_by_velocity(const Step &step)
{
  return step.branch(std::numeric_limits<double>::infinity()).velocity;
}

/// A state without any symmetry.
template <int dim>
StepSolution make_state(const Space<dim> &space, const Step &step)
{
  const auto vector = [&](const double size, const double phase)
  {
    return small_problem::interpolated<dim>(space,
                                            [=](const Point<dim> &x)
                                            {
                                              Tensor<1, dim> value;
                                              for (unsigned int c = 0; c < dim; ++c)
                                                value[c] = size * wave(x, phase + 2. * c);
                                              return value;
                                            });
  };
  const auto scalar = [&](const double phase)
  {
    return small_problem::interpolated_pressure<dim>(
        space, [phase](const Point<dim> &x, unsigned int) { return wave(x, phase); });
  };
  StepSolution state;
  state.step = step;
  state.velocity = vector(1., 0.);
  state.displacement = vector(0.12, 1.);
  state.acceleration = vector(0.8, 4.);
  state.pressure = scalar(2.);
  state.pressure_rate = scalar(3.);
  state.boundary_pressures = {2.1};
  return state;
}

/// The rows of momentum and of the negative of volume, one after the other.
template <int dim>
std::vector<double>
rows_of(const Space<dim> &space, DeformationTerms<dim> &terms, const StepSolution &state)
{
  DistributedVector momentum = space.velocity_vector(), volume = space.pressure_vector();
  terms.add(state, momentum, volume);
  std::vector<double> rows(momentum.begin(), momentum.end());
  for (unsigned int k = 0; k < volume.locally_owned_size(); ++k)
    rows.push_back(-volume.begin()[k]);
  return rows;
}

/// The history of branches of which one step has been made from this displacement, and the next one
/// is known. None without branches.
template <int dim>
std::unique_ptr<MetricHistory<dim>> make_metrics(const Space<dim> &space, const Problem &problem)
{
  std::unique_ptr<MetricHistory<dim>> metrics = MetricHistory<dim>::make(space, problem);
  if (metrics == nullptr)
    return metrics;
  metrics->reinit();
  const DistributedVector velocity = space.velocity_vector(), pressure = space.pressure_vector(),
                          metric = metrics->vector();
  StateSizes sizes(velocity, pressure, metric, metric);
  metrics->visit(sizes);
  return metrics;
}

/// Brings it to a state that is not relaxed, and predicts the step.
template <int dim>
void set_history(const Space<dim> &space,
                 const Problem &problem,
                 MetricHistory<dim> &metrics,
                 DeformationTerms<dim> &terms,
                 const Step &step)
{
  StepSolution state = make_state(space, step);
  state.displacement *= 0.3;
  terms.start_from(state.displacement);
  metrics.predict(step);
  state.displacement *= 2.;
  BranchHistory history(problem.materials, problem.deformation);
  history.reinit(state.velocity, std::vector<std::vector<unsigned int>>(1));
  history.displacement() = state.displacement;
  terms.finish_step(state, {state.velocity, state.pressure, history});
  metrics.predict(step);
}

/// state + factor times a change, with what follows from it.
StepSolution
changed(const StepSolution &state, const std::vector<double> &change, const double factor)
{
  StepSolution result = state;
  const unsigned int n_velocity = state.velocity.locally_owned_size();
  for (unsigned int i = 0; i < n_velocity; ++i)
  {
    result.velocity.begin()[i] += factor * change[i];
    result.acceleration.begin()[i] += factor * state.step.a0 * change[i];
    result.displacement.begin()[i] += factor * displacement_by_velocity(state.step) * change[i];
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
                      const std::string &law,
                      const Step &step,
                      const bool relaxes = false,
                      const Prestretch &prestretch = Prestretch())
{
  const Model model = dim == 3                  ? Model::three_dimensional
                      : space.is_axisymmetric() ? Model::axisymmetric
                                                : Model::plane_strain;
  Problem problem = make_problem(model, law, 0.8);
  add_pressure(problem);
  add_cavity(problem);
  add_body_force<dim>(problem);
  if (relaxes)
    add_branches(problem);
  problem.materials[0].prestretch = prestretch;
  if (step.finds_unloaded_shape)
    problem.unloaded_shape = UnloadedShape::inverse_solve;
  const auto metrics = make_metrics(space, problem);
  DeformationTerms<dim> terms(space, problem, metrics.get());
  terms.reinit();
  if (relaxes)
    set_history(space, problem, *metrics, terms, step);
  const StepSolution state = make_state(space, step);
  // Any change, nothing at hanging nodes.
  const DistributedVector velocity = small_problem::interpolated<dim>(
      space,
      [](const Point<dim> &x) { return wave(x, 7.) * Point<dim>::unit_vector(dim - 1) + 0.3 * x; });
  const DistributedVector pressure = small_problem::interpolated_pressure<dim>(
      space, [](const Point<dim> &x, unsigned int) { return wave(x, 9.); });
  std::vector<double> change(velocity.begin(), velocity.end());
  change.insert(change.end(), pressure.begin(), pressure.end());

  const double h = 1e-5;
  const std::vector<double> above = rows_of(space, terms, changed(state, change, h)),
                            below = rows_of(space, terms, changed(state, change, -h));
  EntrySums sums;
  sums.begin(static_cast<int>(change.size()));
  terms.add_derivative(state, space.velocity_hanging, sums);
  sums.finish();
  const Triplets &matrix = sums.matrix();
  std::vector<double> product(change.size(), 0.);
  for (std::size_t k = 0; k < matrix.values.size(); ++k)
    product[matrix.rows[k]] += matrix.values[k] * change[matrix.columns[k]];
  DistributedVector momentum = space.velocity_vector(), volume = space.pressure_vector();
  terms.keep_derivative(state);
  terms.add_derivative_product(velocity, pressure, momentum, volume);
  std::vector<double> kept(momentum.begin(), momentum.end());
  for (unsigned int k = 0; k < volume.locally_owned_size(); ++k)
    kept.push_back(-volume.begin()[k]);
  const unsigned int n_velocity = velocity.locally_owned_size();
  double largest = 0., largest_volume = 0., difference = 0., of_volume = 0., between = 0.;
  for (std::size_t i = 0; i < product.size(); ++i)
  {
    const double error = std::abs(product[i] - (above[i] - below[i]) / (2. * h));
    between = std::max(between, std::abs(product[i] - kept[i]));
    (i < n_velocity ? largest : largest_volume) =
        std::max(i < n_velocity ? largest : largest_volume, std::abs(product[i]));
    (i < n_velocity ? difference : of_volume) =
        std::max(i < n_velocity ? difference : of_volume, error);
  }
  check::is_true(name + ": there is a derivative", largest > 0.1 && largest_volume > 0.01);
  check::absolute(name + ": derivative of momentum", difference / largest, 0., 1e-8);
  // The rate of a mean stress leaves out the change of its own derivative.
  if (law != "st venant kirchhoff" || !step.extrapolate)
    check::absolute(name + ": derivative of volume", of_volume / largest_volume, 0., 1e-8);
  check::absolute(name + ": kept derivative", between / largest, 0., 1e-13);
}

/// The displacement (F - 1) x.
template <int dim>
DistributedVector homogeneous(const Space<dim> &space, const Tensor<2, dim> &deformation_gradient)
{
  return small_problem::interpolated<dim>(space, [&](const Point<dim> &x)
                                          { return deformation_gradient * x - x; });
}

DistributedVector constant(const Space<2> &space, const double value)
{
  return small_problem::interpolated_pressure<2>(space, [value](const Point<2> &, unsigned int)
                                                 { return value; });
}
} // namespace

UNIT_TEST(deformation_terms)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  small_problem::Mesh<2> mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(mesh, {3, 2});
  small_problem::refine<2>(mesh, [](const Point<2> &x) { return x[0] < 1. || x[1] > 1.; });
  Space<2> space(mesh, SpaceParameters(), Model::plane_strain, 1);
  space.distribute();
  small_problem::Mesh<2> round_mesh(MPI_COMM_WORLD);
  small_problem::make_box<2>(round_mesh, {2, 2}, Point<2>(0., 0.5));
  Space<2> round_space(round_mesh, SpaceParameters(), Model::axisymmetric, 1);
  round_space.distribute();
  small_problem::Mesh<3> solid_mesh(MPI_COMM_WORLD);
  small_problem::make_box<3>(solid_mesh, {2, 1, 1}, Point<3>(0., 0.3, 0.2));
  Space<3> solid_space(solid_mesh, SpaceParameters(), Model::three_dimensional, 1);
  solid_space.distribute();

  const Step implicit = backward_differencing_step(0., 0.3, 0.3, Update::implicit),
             middle = crank_nicolson_step(0., 0.3);
  for (const StrainLawType &row : strain_law_types())
    for (const Step &step : {implicit, middle})
    {
      const std::string name = row.name + (step.extrapolate ? ", middle" : ", implicit");
      check_derivative(name + ", plane", space, row.name, step);
      check_derivative(name + ", axisymmetric", round_space, row.name, step);
      check_derivative(name + ", in space", solid_space, row.name, step);
    }
  for (const Step &step : {implicit, middle})
  {
    const std::string name = step.extrapolate ? "relaxing, middle" : "relaxing, implicit";
    check_derivative(name + ", plane", space, "neo hookean", step, true);
    check_derivative(name + ", axisymmetric", round_space, "mooney rivlin", step, true);
    check_derivative(name + ", in space", solid_space, "holzapfel gasser ogden", step, true);
    const Prestretch prestretch{1.3, 1.1};
    const std::string stretched = "prestretched, " + name;
    check_derivative(stretched + ", plane", space, "neo hookean", step, true, prestretch);
    check_derivative(stretched + ", axisymmetric", round_space, "holzapfel gasser ogden", step,
                     false, prestretch);
    check_derivative(stretched + ", in space", solid_space, "mooney rivlin", step, true,
                     prestretch);
  }

  Step unloading = implicit;
  unloading.finds_unloaded_shape = true;
  for (const StrainLawType &row : strain_law_types())
  {
    const std::string name = row.name + ", unloaded shape";
    check_derivative(name + ", plane", space, row.name, unloading);
    check_derivative(name + ", axisymmetric", round_space, row.name, unloading);
    check_derivative(name + ", in space", solid_space, row.name, unloading, false,
                     Prestretch{1.3, 0.});
  }

  // A body that is turned has no stress, and keeps its volume.
  {
    Problem problem = make_problem(Model::plane_strain, "neo hookean", 0.);
    DeformationTerms<2> terms(space, problem);
    terms.reinit();
    Tensor<2, 2> rotation;
    rotation[0][0] = rotation[1][1] = std::cos(1.2);
    rotation[1][0] = std::sin(1.2);
    rotation[0][1] = -rotation[1][0];
    StepSolution state = make_state(space, implicit);
    for (DistributedVector *vector : {&state.velocity, &state.acceleration, &state.pressure})
      *vector = 0.;
    state.displacement = homogeneous<2>(space, rotation);
    // At hanging nodes the vectors have no values of their own.
    const std::vector<double> rows = rows_of(space, terms, state);
    double largest = 0.;
    for (const double row : rows)
      largest = std::max(largest, std::abs(row));
    check::absolute("a turned body has no stress", largest, 0., 1e-13);
    // A pressure on its left side, whose outward normal (-1, 0) is turned by 1.2.
    add_pressure(problem);
    problem.conditions[0].normal.along_normal = Waveform(1.7);
    DeformationTerms<2> loaded(space, problem);
    loaded.reinit();
    const auto total = [&](const unsigned int component)
    {
      return -powers_of(
                  loaded, state,
                  small_problem::interpolated<2>(space, [&](const Point<2> &)
                                                 { return Point<2>::unit_vector(component); }))
                  .load;
    };
    check::relative("a pressure follows a turned body, x", total(0), 2. * 1.7 * std::cos(1.2),
                    1e-12);
    check::relative("a pressure follows a turned body, y", total(1), 2. * 1.7 * std::sin(1.2),
                    1e-12);
  }

  // Stretched by 1.5 along x and 0.8 along y: J = 1.2, tau = mu J^(-2/3) dev(F F^T), and the force
  // on the right side is P_xx = (tau_xx - J p)/1.5 on its height 2.
  {
    const Problem problem = make_problem(Model::plane_strain, "neo hookean", 0.);
    DeformationTerms<2> terms(space, problem);
    terms.reinit();
    Tensor<2, 2> stretch;
    stretch[0][0] = 1.5;
    stretch[1][1] = 0.8;
    StepSolution state = make_state(space, implicit);
    state.velocity = 0.;
    state.displacement = homogeneous<2>(space, stretch);
    state.pressure = constant(space, 0.9);
    const DistributedVector along =
        small_problem::interpolated<2>(space,
                                       [](const Point<2> &x) {
                                         return Tensor<1, 2>({x[0] / 3., 0.});
                                       });
    const NonlinearPowers powers = powers_of(terms, state, along);
    const double mean = (2.25 + 0.64 + 1.) / 3., tau = 2. * std::pow(1.2, -2. / 3.) * (2.25 - mean);
    check::relative("stretch: force of the law", powers.strain, 2. * tau / 1.5, 1e-12);
    check::relative("stretch: force of the pressure", powers.compression, -2. * 1.2 * 0.9 / 1.5,
                    1e-12);
    // Rows of volume, by the pressure 1 everywhere: (ln J + p/K)/b J times the area.
    const std::vector<double> rows = rows_of(space, terms, state);
    double sum = 0.;
    for (std::size_t i = state.velocity.locally_owned_size(); i < rows.size(); ++i)
      sum -= rows[i];
    check::relative("stretch: rows of volume", sum,
                    6. * 1.2 * (std::log(1.2) + 0.9 / 7.) / displacement_by_velocity(implicit),
                    1e-12);
    // A body that is turned inside out.
    stretch[1][1] = -0.8;
    state.displacement = homogeneous<2>(space, stretch);
    check::throws<StepFailure>(
        "a body turned inside out", [&]() { rows_of(space, terms, state); },
        "turned inside out in the region 'body'");
  }

  // A body that is brought to its stress-free shape, 1/1.3 times as long, has no stress.
  {
    Problem problem = make_problem(Model::three_dimensional, "neo hookean", 0.);
    problem.materials[0].prestretch.axial = 1.3;
    DeformationTerms<3> terms(solid_space, problem);
    terms.reinit();
    StepSolution state = make_state(solid_space, implicit);
    for (DistributedVector *vector : {&state.velocity, &state.acceleration, &state.pressure})
      *vector = 0.;
    Tensor<2, 3> shortened(unit_symmetric_tensor<3>());
    shortened[0][0] = 1. / 1.3;
    state.displacement = homogeneous<3>(solid_space, shortened);
    double largest = 0.;
    for (const double row : rows_of(solid_space, terms, state))
      largest = std::max(largest, std::abs(row));
    check::absolute("prestretched: free of stress where it is let go", largest, 0., 1e-13);
    // In the shape of the mesh: tau = mu 1.3^(-2/3) dev diag(1.69, 1, 1) per stress-free volume, on
    // a section of 1.
    state.displacement = 0.;
    state.acceleration = small_problem::interpolated<3>(solid_space, [](const Point<3> &)
                                                        { return Point<3>::unit_vector(0); });
    const DistributedVector along =
        small_problem::interpolated<3>(solid_space,
                                       [](const Point<3> &x) {
                                         return Tensor<1, 3>({x[0] / 2., 0., 0.});
                                       });
    check::relative("prestretched: axial force", powers_of(terms, state, along).strain,
                    2. * std::pow(1.3, -2. / 3.) * (1.69 - 3.69 / 3.) / 1.3, 1e-12);
    // The mass is 3 kg/m^3 x 2 m^3/1.3.
    check::relative("prestretched: inertia", powers_of(terms, state, state.acceleration).inertia,
                    6. / 1.3, 1e-12);
  }

  {
    Problem problem = make_problem(Model::plane_strain, "neo hookean", 0.);
    add_pressure(problem);
    problem.conditions[0].normal.along_normal = Waveform(1.7);
    problem.interior.body_force = {Waveform(0.4), Waveform(-0.9)};
    DeformationTerms<2> terms(space, problem);
    terms.reinit();
    check_powers("hanging nodes", terms, make_state(space, implicit),
                 small_problem::interpolated<2>(space,
                                                [](const Point<2> &x) {
                                                  return Tensor<1, 2>({1. + x[0] * x[1], x[1]});
                                                }));
  }

  // The power of the law's stress is the rate of its energy; with branches while their metrics
  // stay.
  for (const bool relaxes : {false, true})
    for (const StrainLawType &row : strain_law_types())
    {
      // The energy of such a law has that of the volume, too.
      if (row.needs_bulk_modulus)
        continue;
      Problem problem = make_problem(Model::axisymmetric, row.name, 0.);
      if (relaxes)
      {
        add_branches(problem);
        problem.materials[0].prestretch = {1.3, 1.1};
      }
      const auto metrics = make_metrics(round_space, problem);
      DeformationTerms<2> terms(round_space, problem, metrics.get());
      terms.reinit();
      if (relaxes)
      {
        set_history(round_space, problem, *metrics, terms, implicit);
        metrics->predict(euler_step(0., 1e-300, Update::implicit));
      }
      const StepSolution state = make_state(round_space, implicit);
      BranchHistory history(problem.materials, problem.deformation);
      history.reinit(state.velocity, {{}});
      const double h = 1e-5;
      const auto energy_at = [&](const double time)
      {
        history.displacement() = state.displacement;
        history.displacement().add(time, state.velocity);
        return terms.energy_of(0, {state.velocity, state.pressure, history}).strain;
      };
      check::relative(row.name + (relaxes ? ", relaxing and prestretched" : "") +
                          ": power and rate of the energy",
                      powers_of(terms, state, state.velocity).strain,
                      (energy_at(h) - energy_at(-h)) / (2. * h), 1e-8);
    }

  // What branches turn into heat, in a block that is sheared by 1 at once and then held: mu/(2 tau)
  // (tr(A^-1 Cb^-1) + tr(Cb A) - 6) with A = Cb^-1 + exp(-t/tau) (1 - Cb^-1). Over the step of 0.3
  // s, for the shear g: tr(Cb A) - 3 = g^2 exp(-t/tau) in both orders.
  {
    Problem problem = make_problem(Model::plane_strain, "neo hookean", 0.);
    add_branches(problem);
    const auto metrics = make_metrics(space, problem);
    DeformationTerms<2> terms(space, problem, metrics.get());
    terms.reinit();
    StepSolution state = make_state(space, implicit);
    state.displacement = 0.;
    terms.start_from(state.displacement);
    BranchHistory history(problem.materials, problem.deformation);
    history.reinit(state.velocity, {{}});
    Tensor<2, 2> shear;
    shear[0][0] = shear[1][1] = shear[0][1] = 1.;
    const Step sudden = euler_step(0., 1e-14, Update::implicit),
               held = euler_step(0., 0.3, Update::implicit);
    history.displacement() = state.displacement = homogeneous<2>(space, shear);
    const State present{state.velocity, state.pressure, history};
    double energy[2];
    unsigned int number = 0;
    for (const Step &step : {sudden, held})
    {
      metrics->predict(step);
      terms.finish_step(state, present);
      energy[number++] = terms.energy_of(0, present).strain;
    }
    // X = Cb A - 1 has the trace s = g^2 e, e = exp(-t/tau), and the determinant of 1 + X is 1 + e
    // (1 - e) g^2, in the plane.
    double expected_energy = 0.5 * 2., expected_heat = 0.;
    for (const Branch &branch : {Branch{1.2, 0.5}, Branch{0.7, 0.1}})
    {
      const double e = std::exp(-0.3 / branch.relaxation_time), d = 1. + e * (1. - e);
      expected_energy += 0.5 * branch.shear_modulus * (e - std::log(d));
      // tr(X^-1) of the 2 x 2 part is tr X / det X.
      expected_heat +=
          0.5 * branch.shear_modulus / branch.relaxation_time * ((2. + e) / d + 2. + e - 4.);
    }
    check::relative("sheared at once: energy", energy[0], 6. * 0.5 * (2. + 1.2 + 0.7), 1e-10);
    check::relative("sheared and held: energy", energy[1], 6. * expected_energy, 1e-10);
    check::relative("sheared and held: heat", terms.relaxation_power(0), 6. * expected_heat, 1e-10);
  }
}
} // namespace test_of_deformation_terms
