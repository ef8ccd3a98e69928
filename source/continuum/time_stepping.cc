#include <continua/continuum/time_stepping.h>

#include <continua/base/input_error.h>
#include <continua/continuum/local_product.h>
#include <continua/continuum/state_vectors.h>
#include <continua/continuum/step_extremes.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
std::string text_of(const Step &step, const RunError &error)
{
  std::ostringstream text;
  text << "in the step to t = " << step.time << " s " << error.what();
  return text.str();
}
} // namespace

TimeStepping::TimeStepping(const Problem &problem, Operators &operators, Log &log)
    : problem(problem),
      operators(operators),
      log(log),
      history(problem.materials, problem.deformation),
      bulk_history(problem.materials),
      outlets(problem, operators),
      unknown_pressures(problem, operators),
      wall_shear(problem, operators),
      products(problem, operators, history, velocity, velocity_older),
      ledger(problem, operators, outlets, history, bulk_history, &products),
      kept([this](StateVisitor &visitor) { visit(visitor); })
{
  if (operators.is_nonlinear())
    newton.emplace(problem, *operators.nonlinear(), operators.system(), operators.products(),
                   outlets, unknown_pressures, log);
}

void TimeStepping::initialise()
{
  setup();
  outlets.initialise();
  unknown_pressures.initialise();
  present_time = pressure_known_time = 0.;
  operators.set_initial_state(velocity, history.displacement(), pressure);
  bulk_history.start(pressure);
  deform_by_imbalance(0.);
  velocity_older.equ(1., velocity);
  pressure_older.equ(1., pressure);
  pressure_known.equ(1., pressure);
  operators.start_from(present());
  wall_shear.start(present());
}

void TimeStepping::forget_linearisation() const
{
  if (!newton)
    return;
  newton->forget_factor();
  operators.nonlinear()->forget_linearisation();
}

std::vector<bool> TimeStepping::nodes_of_solids() const
{
  std::vector<bool> of_solids(velocity.locally_owned_size(), false);
  const std::vector<std::vector<unsigned int>> nodes = operators.velocity_nodes();
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (!problem.materials[region].shear.branches.empty())
      for (const unsigned int i : nodes[region])
        of_solids[i] = true;
  return of_solids;
}

void TimeStepping::stop_solids()
{
  const std::vector<bool> of_solids = nodes_of_solids();
  for (unsigned int i = 0; i < of_solids.size(); ++i)
    if (of_solids[i])
      velocity.begin()[i] = solution.velocity.begin()[i] = 0.;
  products.forget();
  ledger.forget_forces();
}

void TimeStepping::start_from_present_state()
{
  present_time = pressure_known_time = 0.;
  // What flowed on the way here is no displacement of the run.
  const std::vector<bool> has_branches = nodes_of_solids();
  DistributedVector &displacement = history.displacement();
  for (unsigned int i = 0; i < has_branches.size(); ++i)
    if (!has_branches[i])
      displacement.begin()[i] = 0.;
  velocity_older.equ(1., velocity);
  pressure_older.equ(1., pressure);
  pressure_known.equ(1., pressure);
  kept.forget();
  forget_linearisation();
  products.forget();
  ledger.forget_forces();
  outlets.start_steady();
  operators.start_from(present());
}

void TimeStepping::begin_unloaded_shape()
{
  // It goes on from the shape that is known, as on a mesh that was refined.
  history.displacement().equ(-1., *operators.unloaded_displacement());
  stop_finite_solids(velocity);
  products.forget();
  forget_linearisation();
}

void TimeStepping::keep_unloaded_shape()
{
  velocity_work.equ(-1., history.displacement());
  operators.set_unloaded_displacement(velocity_work);
  history.displacement() = 0.;
  stop_finite_solids(velocity);
  start_from_present_state();
}

void TimeStepping::setup()
{
  SectionTimer::Scope scope(log.timer(), "setup");
  operators.setup();
  const DistributedVector zero_velocity = operators.velocity_vector(),
                          zero_pressure = operators.pressure_vector();
  history.reinit(zero_velocity, operators.velocity_nodes());
  bulk_history.reinit(zero_pressure, operators.pressure_nodes());
  outlets.build();
  unknown_pressures.build();
  solution.boundary_pressures = unknown_pressures.pressures();
  wall_shear.reinit();
  products.reinit();
  ledger.reinit();
  if (newton)
    newton->reinit(zero_velocity, zero_pressure);
  for (DistributedVector *vector :
       {&solution.velocity, &solution.acceleration, &solution.prescribed, &prescribed, &momentum,
        &velocity_work, &mixture})
    vector->reinit(zero_velocity);
  for (DistributedVector *vector :
       {&solution.pressure, &solution.pressure_rate, &mass, &pressure_work, &mass_work})
    vector->reinit(zero_pressure);
  if (problem.has_regions_of(RegionModel::finite_solid))
    solution.displacement.reinit(zero_velocity);
  if (problem.mesh_moves)
    for (DistributedVector *vector : {&solution.mesh_displacement, &solution.mesh_velocity})
      vector->reinit(zero_velocity);
  if (problem.convection.is_explicit())
    solution.extrapolated_velocity.reinit(zero_velocity);
  const DistributedVector zero_metric = operators.internal_metric_vector();
  const DistributedVector zero_vertex = operators.mesh_vertex_vector();
  StateSizes sizes(zero_velocity, zero_pressure, zero_metric, zero_vertex);
  visit(sizes);
  pressures_without_history = operators.pressures_without_history();
  // Copies are collective: a rank without such a pressure makes them, too.
  some_pressures_without_history =
      Utilities::MPI::max(pressures_without_history.empty() ? 0 : 1, problem.communicator) == 1;
  kept.forget();
}

void TimeStepping::visit(StateVisitor &visitor)
{
  visitor.levels("velocity", StateKind::velocity, velocity, velocity_older);
  visitor.levels("pressure", StateKind::pressure, pressure, pressure_older);
  history.visit(visitor);
  bulk_history.visit(visitor);
  outlets.visit(visitor);
  unknown_pressures.visit(visitor);
  operators.visit(visitor);
  wall_shear.visit(visitor);
  visitor.vector("known pressure", StateKind::pressure, pressure_known);
  visitor.value("time of the known pressure", pressure_known_time);
  visitor.value("present time", present_time);
}

void TimeStepping::report_exponential_branches(const Step &step)
{
  for (const double relaxation_time : history.exponential_branches(step))
    if (exponential_branches_reported.insert(relaxation_time).second)
    {
      std::ostringstream text;
      text << "The time step is longer than the relaxation time " << relaxation_time
           << " s: its branches take the exponential update";
      log.line(text.str());
    }
}

StepReport TimeStepping::advance(const Step &given_step)
{
  const Step step = operators.variant().adapted(given_step);
  StepReport report;
  try
  {
    if (!operators.variant().solves_for_displacement() && kept.move_older_level(step))
      products.forget_older();
    operators.begin_step(step, present());
    if (operators.variant().solves_for_displacement())
      operators.variant().make_displacement_step(step, velocity, history.displacement(), solution,
                                                 report);
    else
      balance(step, report);
  }
  catch (const StepFailure &error)
  {
    if (newton)
      newton->forget_factor();
    throw StepFailure(text_of(step, error));
  }
  catch (const RunError &error)
  {
    throw RunError(text_of(step, error));
  }
  SectionTimer::Scope scope(log.timer(), "update");
  set_extremes(step, velocity, solution.velocity, solution.pressure, report);
  if (step.finds_steady_state)
    report.steady_change = steady_change(step);
  finish(step);
  return report;
}

void TimeStepping::balance(const Step &step, StepReport &report)
{
  deform_by_jump(step);
  const SystemChange change = prepare(step, report);
  {
    SectionTimer::Scope scope(log.timer(), "right-hand side");
    set_momentum(step);
    set_mass(step);
    if (!operators.prescribed().is_homogeneous())
    {
      set_prescribed(step);
      if (!operators.is_nonlinear())
        operators.system().eliminate_prescribed(solution.prescribed, momentum, mass);
    }
  }
  SectionTimer::Scope scope(log.timer(), "solve");
  if (operators.is_nonlinear())
  {
    iterate(step, change != SystemChange::none, report);
    return;
  }
  if (operators.system().starts_from_guess())
  {
    solution.velocity.equ(1., velocity);
    solution.pressure.equ(1., pressure);
  }
  operators.system().solve(solution.prescribed, momentum, mass, solution.velocity,
                           solution.pressure, report);
  outlets.couple(step, velocity, solution.velocity, solution.pressure);
  outlets.finish_step(step);
}

void TimeStepping::iterate(const Step &step, const bool system_is_new, StepReport &report)
{
  extrapolate_velocity(step);
  if (step.finds_steady_state)
    stop_finite_solids(solution.velocity);
  operators.prescribed().set_prescribed(solution.prescribed, solution.velocity);
  solution.pressure.equ(1., pressure);
  solution.boundary_pressures = unknown_pressures.pressures();
  solution.step = step;
  if (problem.has_regions_of(RegionModel::finite_solid))
    history.predict_displacement(step, velocity, mixture);
  newton->solve(
      {step, coefficients, system_is_new, momentum, mass, pressure_work, velocity, mixture},
      solution, report);
}

void TimeStepping::extrapolate_velocity(const Step &step)
{
  // To the level that is balanced, as the last step went. Where convection is explicit this is a
  // part of the scheme, and the distance counts; for Newton's iteration it is a first guess.
  const bool is_of_scheme = problem.convection.is_explicit() && !step.finds_steady_state;
  double extrapolation = 0.;
  if (!step.is_start && step.extrapolate)
    extrapolation =
        is_of_scheme && step.older_distance > 0. ? 0.5 * step.size() / step.older_distance : 0.5;
  else if (!step.is_start && step.a2 != 0.)
    extrapolation = step.size() / step.older_distance;
  solution.velocity.equ(1. + extrapolation, velocity);
  if (extrapolation != 0.)
    solution.velocity.add(-extrapolation, velocity_older);
}

void TimeStepping::stop_finite_solids(DistributedVector &of_velocity) const
{
  // On the way to a steady state the steps of a solid grow, and its velocity over a longer one
  // would be a multiple of the last displacement.
  if (!problem.has_regions_of(RegionModel::finite_solid))
    return;
  const std::vector<std::vector<unsigned int>> nodes = operators.velocity_nodes();
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (problem.region_model(region) == RegionModel::finite_solid)
      for (const unsigned int i : nodes[region])
        of_velocity.begin()[i] = 0.;
}

SystemChange TimeStepping::prepare(const Step &step, StepReport &report)
{
  SectionTimer::Scope scope(log.timer(), "factor");
  coefficients.set(problem, step);
  // Regions that are left out change with the step, too, and the tangent with them.
  const bool is_other = !(coefficients == equation_coefficients);
  equation_coefficients = coefficients;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (has_all_terms_in(region))
      coefficients.leave_out(region);
  SystemChange change = operators.system().prepare(coefficients, step.pressure_time);
  if (change == SystemChange::none && is_other && operators.is_nonlinear())
    change = SystemChange::coefficients;
  if (change != SystemChange::none && !operators.is_nonlinear())
    outlets.respond(report);
  if (change == SystemChange::factor)
    ++report.factors;
  if (report.factors > 0 || (change != SystemChange::none && operators.is_nonlinear()))
    report_exponential_branches(step);
  return change;
}

void TimeStepping::set_momentum(const Step &step)
{
  // Inertia of the past, forces of the branches and of the supports, loads.
  velocity_work.equ(-step.a1, velocity);
  if (step.a2 != 0.)
    velocity_work.add(-step.a2, velocity_older);
  solution.acceleration.equ(-1., velocity_work);
  momentum = 0.;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    if (has_all_terms_in(region))
      continue;
    const double density = problem.materials[region].density;
    if (products.has(region))
      momentum.add(density, products.past_inertia(region, step));
    else
    {
      operators.products().multiply_mass(region, solution.velocity, velocity_work);
      momentum.add(density, solution.velocity);
    }
    if (products.is_elastic(region))
      products.add_past_stress(region, step, momentum);
    else if (history.predict(region, step, velocity, mixture))
    {
      operators.variant().multiply_past_stiffness(region, solution.velocity, mixture);
      momentum.add(-1., solution.velocity);
    }
  }
  if (problem.has_supports() && !step.finds_unloaded_shape)
  {
    history.predict_displacement(step, velocity, mixture);
    for (unsigned int region = 0; region < problem.materials.size(); ++region)
    {
      operators.products().multiply_support_stiffness(region, solution.velocity, mixture);
      momentum.add(-1., solution.velocity);
    }
  }
  if (step.load_factor == 1.)
    operators.loads().add(step.balance_time, momentum);
  else
  {
    velocity_work = 0.;
    operators.loads().add(step.balance_time, velocity_work);
    momentum.add(step.load_factor, velocity_work);
  }
  outlets.take_forces(momentum);
}

void TimeStepping::set_mass(const Step &step)
{
  mass = 0.;
  if (!operators.variant().has_pressure())
    return;
  // The pressure of the past.
  pressure_work.equ(step.pressure_old, pressure);
  if (step.pressure_older != 0.)
    pressure_work.add(step.pressure_older, pressure_older);
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    const double compressibility = coefficients.compressibility[region];
    if (has_all_terms_in(region))
      continue;
    const bool relaxes = bulk_history.has(region);
    if (relaxes)
      bulk_history.predict(region, step, mass_work);
    if (relaxes || compressibility != 0.)
    {
      operators.products().multiply_pressure_mass(region, solution.pressure,
                                                  relaxes ? mass_work : pressure_work);
      mass.add(compressibility, solution.pressure);
    }
    if (step.divergence_old && !relaxes)
    {
      // What relaxes has the rate of the past in its own prediction.
      if (products.has(region))
        mass.add(-1., products.divergence(region));
      else
      {
        operators.variant().set_past_dilatation(region, present(), solution.pressure);
        mass.add(-1., solution.pressure);
      }
    }
  }
  if (!operators.variant().corrects_fluxes())
    return;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (bulk_history.has(region))
      bulk_history.predict(region, step, pressure_work);
  operators.variant().add_past_flux_correction(pressure_work, mass);
}

void TimeStepping::set_prescribed(const Step &step)
{
  operators.prescribed().evaluate(step.extrapolate ? step.time : step.balance_time, prescribed);
  if (!step.extrapolate)
  {
    solution.prescribed.equ(step.load_factor, prescribed);
    return;
  }
  // The end of the step has what is prescribed there, so its middle the mean of that and of the
  // start.
  operators.prescribed().prescribed_part(velocity, solution.prescribed);
  solution.prescribed.sadd(0.5, 0.5, prescribed);
  outlets.leave_out_ports(solution.prescribed);
}

void TimeStepping::finish(const Step &step)
{
  if (!operators.variant().solves_for_displacement())
  {
    solution.acceleration.add(step.a0, solution.velocity);
    history.advance(step, velocity, solution.velocity);
    bulk_history.advance(step, solution.pressure);
  }
  // A pressure that is no unknown is left as it is here: state() sets it.
  velocity_older.swap(velocity);
  pressure_older.swap(pressure);
  if (step.extrapolate)
  {
    velocity.equ(2., solution.velocity);
    velocity.add(-1., velocity_older);
    pressure.equ(2., solution.pressure);
    pressure.add(-1., pressure_older);
    extrapolate_pressure(step);
  }
  else
  {
    // An assignment would build a plan of exchange between ranks.
    velocity.equ(1., solution.velocity);
    pressure.equ(1., solution.pressure);
  }
  if (some_pressures_without_history)
  {
    pressure_known.equ(1., solution.pressure);
    pressure_known_time = step.balance_time;
  }
  unknown_pressures.finish_step(solution);
  present_time = step.time;
  solution.step = step;
  products.advance();
  ledger.forget_forces();
  operators.finish_step(solution, present());
  wall_shear.advance(step, present());
  kept.advance(step);
}

void TimeStepping::extrapolate_pressure(const Step &step)
{
  // Where 1/K = 0 the pressure has no history: the balanced one belongs to the middle of the step,
  // and the line through the last two of them leads to its end.
  const double factor = (step.time - step.balance_time) / (step.balance_time - pressure_known_time);
  for (const unsigned int i : pressures_without_history)
    pressure.begin()[i] = solution.pressure.begin()[i] +
                          factor * (solution.pressure.begin()[i] - pressure_known.begin()[i]);
}

void TimeStepping::deform_by_imbalance(const double time)
{
  if (!operators.variant().has_massless_velocities())
    return;
  momentum = 0.;
  operators.loads().add(time, momentum);
  outlets.add_present_forces(time, velocity, momentum);
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    set_mixture(present(), region, problem.materials[region], mixture);
    operators.products().multiply_stiffness(region, velocity_work, mixture);
    momentum.add(-1., velocity_work);
    operators.products().multiply_gradient(region, velocity_work, pressure);
    momentum.add(-1., velocity_work);
  }
  deform_massless();
}

void TimeStepping::deform_by_jump(const Step &step)
{
  if (step.update != Update::trapezoidal || !operators.variant().has_massless_velocities() ||
      !operators.loads().jumps(step.time_old, step.balance_time))
    return;
  // The load's change in the step, less what the step before says of its smooth part.
  momentum = 0.;
  operators.loads().add(step.balance_time, momentum);
  velocity_work = 0.;
  operators.loads().add(step.time_old, velocity_work);
  const double before = step.time_old - step.size();
  momentum.add(before < 0. ? -1. : -2., velocity_work);
  if (before >= 0.)
    operators.loads().add(before, momentum);
  deform_massless();
}

void TimeStepping::deform_massless()
{
  if (!operators.variant().deform_at_once(momentum, velocity_work, pressure_work))
    return;
  StateVectors displacements;
  history.visit(displacements);
  for (DistributedVector *const vector : displacements.velocities)
    vector->add(1., velocity_work);
  pressure.add(1., pressure_work);
  pressure_older.add(1., pressure_work);
  bulk_history.jump(pressure_work);
  products.forget();
}

double TimeStepping::steady_change(const Step &step)
{
  // What round-off leaves of a region that nothing loads is no change.
  constexpr double least_share = 1e-5;
  const std::vector<std::vector<unsigned int>> nodes = operators.velocity_nodes();
  const double displacement_by_velocity = BranchHistory::step_displacement(step);
  const DistributedVector &displacement = history.displacement();
  const std::size_t n = problem.materials.size();
  // By region: the change, and what it is a part of. Displacements [m] of solids, forces [N] of
  // liquids.
  std::vector<double> sizes(2 * n, 0.);
  for (unsigned int region = 0; region < n; ++region)
  {
    double &change = sizes[region], &total = sizes[n + region];
    if (problem.materials[region].is_solid())
    {
      for (const unsigned int i : nodes[region])
      {
        const double of_step = displacement_by_velocity * solution.velocity.begin()[i];
        change = std::max(change, std::abs(of_step));
        total = std::max(total, std::abs(displacement.begin()[i] + of_step));
      }
      continue;
    }
    const auto force_of = [&](const DistributedVector &of_velocity)
    {
      operators.products().multiply_stiffness(region, velocity_work, of_velocity);
      velocity_work *= problem.materials[region].shear.viscosity;
      operators.products().multiply_mass(region, momentum, of_velocity);
      velocity_work.add(step.a0 * problem.materials[region].density, momentum);
      return velocity_work.linfty_norm();
    };
    mixture.equ(1., solution.velocity);
    total = force_of(mixture);
    mixture.add(-1., velocity);
    change = force_of(mixture);
    operators.products().multiply_gradient(region, velocity_work, solution.pressure);
    total = std::max(total, least_share * velocity_work.linfty_norm());
  }
  Utilities::MPI::max(sizes, problem.communicator, sizes);
  std::array<double, 2> largest{}; // of liquids, of solids
  for (unsigned int region = 0; region < n; ++region)
    largest[problem.materials[region].is_solid()] =
        std::max(largest[problem.materials[region].is_solid()], sizes[n + region]);
  double result = 0.;
  for (unsigned int region = 0; region < n; ++region)
    if (sizes[region] > 0.)
      result = std::max(result,
                        sizes[region] /
                            std::max(sizes[n + region],
                                     least_share * largest[problem.materials[region].is_solid()]));
  return result;
}

bool TimeStepping::steady_is_direct() const
{
  if (operators.is_nonlinear())
    return false;
  bool all_solid = true, all_fluid = true;
  for (const Material &material : problem.materials)
    (material.shear.branches.empty() ? all_solid : all_fluid) = false;
  return all_solid || all_fluid;
}

void TimeStepping::solve_steady(const double time)
{
  AssertThrow(steady_is_direct(), ExcInternalError());
  const bool solid = !problem.materials.front().shear.branches.empty();
  StepReport report;
  {
    SectionTimer::Scope scope(log.timer(), "factor");
    coefficients.set_steady(problem);
    if (operators.system().prepare(coefficients, 1.) != SystemChange::none && !solid)
      outlets.respond(report);
  }
  momentum = 0.;
  mass = 0.;
  operators.loads().add(time, momentum);
  outlets.take_forces(momentum);
  solution.prescribed = 0.;
  // A solid at rest has no velocity to prescribe: its supports hold.
  if (!solid && !operators.prescribed().is_homogeneous())
  {
    operators.prescribed().evaluate(time, prescribed);
    solution.prescribed.equ(1., prescribed);
    operators.system().eliminate_prescribed(solution.prescribed, momentum, mass);
  }
  {
    SectionTimer::Scope scope(log.timer(), "solve");
    velocity_work = 0.;
    operators.system().solve(solution.prescribed, momentum, mass, velocity_work, pressure, report);
  }
  // Nothing flows out of a solid at rest.
  if (!solid)
    outlets.couple_steady(time, velocity_work, pressure);
  if (!std::isfinite(velocity_work.linfty_norm()))
    throw RunError("the steady solution is not finite" +
                   reason_not_finite(velocity_work.get_mpi_communicator()));
  (solid ? history.displacement() : velocity).equ(1., velocity_work);
  present_time = time;
  // As a step without inertia: what the ledger says of it.
  solution.step = Step();
  solution.step.balance_time = time;
  solution.velocity.equ(1., velocity);
  solution.pressure.equ(1., pressure);
  solution.acceleration = 0.;
  products.forget();
  ledger.forget_forces();
}

StepError TimeStepping::step_error()
{
  StepError error;
  error.is_known = kept.error_is_known();
  if (!error.is_known)
    return error;
  SectionTimer::Scope scope(log.timer(), "step error");
  kept.velocity_error(velocity.begin(), velocity_work.begin(), velocity.locally_owned_size());
  // Prescribed velocities are exact, whatever is predicted of them.
  operators.prescribed().clear_prescribed(velocity_work);
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    operators.products().multiply_mass(region, momentum, velocity_work);
    error.kinetic_energy +=
        0.5 * problem.materials[region].density * local_product(velocity_work, momentum);
  }
  error.kinetic_energy = Utilities::MPI::sum(error.kinetic_energy, problem.communicator);
  return error;
}

void TimeStepping::keep_state()
{
  SectionTimer::Scope scope(log.timer(), "step error");
  kept.keep();
}

void TimeStepping::return_to_kept_state()
{
  kept.give_back();
  products.forget();
}

bool TimeStepping::data_jumps(const double begin, const double end) const
{
  return operators.loads().jumps(begin, end) || operators.prescribed().jumps(begin, end) ||
         outlets.jumps(begin, end) || unknown_pressures.jumps(begin, end);
}

State TimeStepping::state()
{
  operators.variant().complete_pressure(history.displacement(), pressure);
  const DistributedVector *const of_mesh = operators.mesh_displacement();
  unknown_pressures.states(of_mesh != nullptr ? *of_mesh : history.displacement());
  return present();
}

PowerBalance TimeStepping::power_balance(const bool relaxation)
{
  return ledger.balance({solution, velocity_older, velocity}, relaxation);
}

Energy TimeStepping::energy()
{
  return ledger.energy(present());
}

void TimeStepping::prepare_refinement()
{
  StateVectors vectors;
  visit(vectors);
  operators.prepare_transfer(vectors);
}

void TimeStepping::transfer()
{
  setup();
  StateVectors vectors;
  visit(vectors);
  operators.finish_transfer(vectors);
  for ([[maybe_unused]] const DistributedVector *vector : vectors.velocities)
    Assert(have_same_layout(*vector, velocity_work), ExcInternalError());
  for ([[maybe_unused]] const DistributedVector *vector : vectors.pressures)
    Assert(have_same_layout(*vector, pressure_work), ExcInternalError());
  products.forget();
  deform_by_imbalance(present_time);
  wall_shear.follow_mesh(present());
}

void TimeStepping::save(ArchiveWriter &archive) const
{
  forget_linearisation();
  save_state(archive, operators.numbering(), kept);
}

void TimeStepping::load(const ArchiveReader &archive)
{
  load_state(archive, operators.numbering(), kept);
  products.forget();
  operators.finish_load();
}
} // namespace Continua
