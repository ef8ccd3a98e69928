#include <continua/continuum/time_stepping.h>

#include <continua/base/input_error.h>
#include <continua/continuum/local_product.h>
#include <continua/continuum/state_vectors.h>
#include <continua/continuum/step_extremes.h>

#include <deal.II/base/mpi.h>

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
      products(problem, operators, history, levels.velocity, levels.velocity_older),
      right_side(problem, operators, history, bulk_history, outlets, products, levels),
      massless_motion(problem, operators, history, bulk_history, outlets, products, levels),
      system(problem, operators, outlets, history, log),
      steady_change(problem, operators),
      solid_nodes(problem, operators),
      steady_solve(problem, operators, outlets, right_side, log),
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
  present_time = 0.;
  operators.set_initial_state(levels.velocity, history.displacement(), levels.pressure);
  bulk_history.start(levels.pressure);
  massless_motion.deform_by_imbalance(0., present());
  levels.forget_older();
  known_pressure.start(levels.pressure);
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

void TimeStepping::stop_solids()
{
  for (DistributedVector *vector : {&levels.velocity, &solution.velocity})
    solid_nodes.clear(*vector);
  products.forget();
  ledger.forget_forces();
}

void TimeStepping::start_from_present_state()
{
  present_time = 0.;
  // What flowed on the way here is no displacement of the run.
  solid_nodes.clear_others(history.displacement());
  levels.forget_older();
  known_pressure.start(levels.pressure);
  kept.forget();
  forget_linearisation();
  products.forget();
  ledger.forget_forces();
  outlets.start_steady();
  operators.start_from(present());
}

void TimeStepping::add_to_averages(const double duration)
{
  if (wall_shear.is_on())
    wall_shear.advance(euler_step(wall_shear.duration(), duration, Update::implicit), present());
}

void TimeStepping::begin_unloaded_shape()
{
  // It goes on from the shape that is known, as on a mesh that was refined.
  history.displacement().equ(-1., *operators.unloaded_displacement());
  solid_nodes.clear_finite(levels.velocity);
  products.forget();
  forget_linearisation();
}

void TimeStepping::keep_unloaded_shape()
{
  velocity_work.equ(-1., history.displacement());
  operators.set_unloaded_displacement(velocity_work);
  history.displacement() = 0.;
  solid_nodes.clear_finite(levels.velocity);
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
  right_side.reinit(zero_velocity, zero_pressure);
  massless_motion.reinit(zero_velocity, zero_pressure);
  for (DistributedVector *vector :
       {&solution.velocity, &solution.acceleration, &solution.prescribed, &velocity_work, &product})
    vector->reinit(zero_velocity);
  for (DistributedVector *vector : {&solution.pressure, &solution.pressure_rate})
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
  known_pressure.reinit(problem, operators);
  kept.forget();
}

void TimeStepping::visit(StateVisitor &visitor)
{
  visitor.levels("velocity", StateKind::velocity, levels.velocity, levels.velocity_older);
  visitor.levels("pressure", StateKind::pressure, levels.pressure, levels.pressure_older);
  history.visit(visitor);
  bulk_history.visit(visitor);
  outlets.visit(visitor);
  unknown_pressures.visit(visitor);
  operators.visit(visitor);
  wall_shear.visit(visitor);
  known_pressure.visit(visitor);
  visitor.value("present time", present_time);
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
      operators.variant().make_displacement_step(step, levels.velocity, history.displacement(),
                                                 solution, report);
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
  set_extremes(step, levels.velocity, solution.velocity, solution.pressure, report);
  if (step.finds_steady_state)
    report.steady_change = steady_change(step, levels.velocity, history.displacement(), solution);
  finish(step);
  return report;
}

void TimeStepping::balance(const Step &step, StepReport &report)
{
  massless_motion.deform_by_jump(step);
  const SystemChange change = system.prepare(step, report);
  DistributedVector &momentum = right_side.momentum(), &mass = right_side.mass();
  {
    SectionTimer::Scope scope(log.timer(), "right-hand side");
    right_side.set(step, system.coefficients(), present(), solution);
    if (!operators.prescribed().is_homogeneous() && !operators.is_nonlinear())
      operators.system().eliminate_prescribed(solution.prescribed, momentum, mass);
  }
  SectionTimer::Scope scope(log.timer(), "solve");
  if (operators.is_nonlinear())
  {
    iterate(step, change != SystemChange::none, report);
    return;
  }
  if (operators.system().starts_from_guess())
  {
    solution.velocity.equ(1., levels.velocity);
    solution.pressure.equ(1., levels.pressure);
  }
  operators.system().solve(solution.prescribed, momentum, mass, solution.velocity,
                           solution.pressure, report);
  outlets.couple(step, levels.velocity, solution.velocity, solution.pressure);
  outlets.finish_step(step);
}

void TimeStepping::iterate(const Step &step, const bool system_is_new, StepReport &report)
{
  // Where convection is explicit this is a part of the scheme; for Newton's iteration it is a first
  // guess.
  levels.extrapolate_velocity(step, problem.convection.is_explicit() && !step.finds_steady_state,
                              solution.velocity);
  // The steps of a solid grow, and its velocity over a longer one would be a multiple of the last
  // displacement.
  if (step.finds_steady_state)
    solid_nodes.clear_finite(solution.velocity);
  operators.prescribed().set_prescribed(solution.prescribed, solution.velocity);
  solution.pressure.equ(1., levels.pressure);
  solution.boundary_pressures = unknown_pressures.pressures();
  solution.step = step;
  if (problem.has_regions_of(RegionModel::finite_solid))
    history.predict_displacement(step, levels.velocity, velocity_work);
  newton->solve({step, system.coefficients(), system_is_new, right_side.momentum(),
                 right_side.mass(), right_side.past_pressure(), levels.velocity, velocity_work},
                solution, report);
}

void TimeStepping::finish(const Step &step)
{
  if (!operators.variant().solves_for_displacement())
  {
    solution.acceleration.add(step.a0, solution.velocity);
    history.advance(step, levels.velocity, solution.velocity);
    bulk_history.advance(step, solution.pressure);
  }
  // A pressure that is no unknown is left as it is here: state() sets it.
  levels.velocity_older.swap(levels.velocity);
  levels.pressure_older.swap(levels.pressure);
  if (step.extrapolate)
  {
    levels.velocity.equ(2., solution.velocity);
    levels.velocity.add(-1., levels.velocity_older);
    levels.pressure.equ(2., solution.pressure);
    levels.pressure.add(-1., levels.pressure_older);
    known_pressure.extrapolate(step, solution.pressure, levels.pressure);
  }
  else
  {
    // An assignment would build a plan of exchange between ranks.
    levels.velocity.equ(1., solution.velocity);
    levels.pressure.equ(1., solution.pressure);
  }
  known_pressure.take(step, solution.pressure);
  unknown_pressures.finish_step(solution);
  present_time = step.time;
  solution.step = step;
  products.advance();
  ledger.forget_forces();
  operators.finish_step(solution, present());
  wall_shear.advance(step, present());
  kept.advance(step);
}

void TimeStepping::solve_steady(const double time)
{
  DistributedVector &solved =
      steady_solve.is_of_solids() ? history.displacement() : levels.velocity;
  steady_solve.solve(time, velocity_work, levels.pressure, solution);
  solved.equ(1., velocity_work);
  present_time = time;
  // As a step without inertia: what the ledger says of it.
  solution.step = Step();
  solution.step.balance_time = time;
  solution.velocity.equ(1., levels.velocity);
  solution.pressure.equ(1., levels.pressure);
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
  kept.velocity_error(levels.velocity.begin(), velocity_work.begin(),
                      levels.velocity.locally_owned_size());
  // Prescribed velocities are exact, whatever is predicted of them.
  operators.prescribed().clear_prescribed(velocity_work);
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    operators.products().multiply_mass(region, product, velocity_work);
    error.kinetic_energy +=
        0.5 * problem.materials[region].density * local_product(velocity_work, product);
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
  operators.variant().complete_pressure(history.displacement(), levels.pressure);
  const DistributedVector *const of_mesh = operators.mesh_displacement();
  unknown_pressures.states(of_mesh != nullptr ? *of_mesh : history.displacement());
  return present();
}

PowerBalance TimeStepping::power_balance(const bool relaxation)
{
  return ledger.balance({solution, levels.velocity_older, levels.velocity}, relaxation);
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
    Assert(have_same_layout(*vector, solution.velocity), ExcInternalError());
  for ([[maybe_unused]] const DistributedVector *vector : vectors.pressures)
    Assert(have_same_layout(*vector, solution.pressure), ExcInternalError());
  products.forget();
  massless_motion.deform_by_imbalance(present_time, present());
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
