#include <continua/finite_element/taylor_hood_solver.h>

#include <continua/base/input_error.h>
#include <continua/continuum/state_vectors.h>
#include <continua/continuum/step_extremes.h>
#include <continua/finite_element/initial_state.h>
#include <continua/finite_element/kelly_indicator.h>
#include <continua/finite_element/taylor_hood_vibration.h>
#include <continua/finite_element/traction_jump.h>

#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
using namespace dealii;

template <int dim>
TaylorHoodSolver<dim>::TaylorHoodSolver(parallel::TriangulationBase<dim> &triangulation,
                                        const Problem &problem,
                                        const TaylorHoodParameters &parameters,
                                        Log &log)
    : problem(problem),
      log(log),
      space(triangulation, parameters.space, problem.model, problem.regions.size()),
      operators(problem.regions.size()),
      constraints(space, problem.conditions),
      loads(space, problem),
      history(problem.materials),
      bulk_history(problem.materials),
      system(space, operators, constraints, parameters.linear_solver),
      outlets(space, problem, loads, constraints),
      power_ledger(space, problem, operators, constraints, loads, outlets),
      mesh_transfer(space),
      evaluation(space, problem),
      output(space, problem, evaluation),
      kept([this](StateVisitor &visitor) { visit(visitor); })
{
}

template <int dim>
void TaylorHoodSolver<dim>::initialise()
{
  setup();
  outlets.initialise();
  present_time = pressure_known_time = 0.;
  set_initial_state(space, problem, operators, log, velocity, history.displacement(), pressure);
  bulk_history.start(pressure);
  velocity_older.equ(1., velocity);
  pressure_older.equ(1., pressure);
  pressure_known.equ(1., pressure);
}

template <int dim>
void TaylorHoodSolver<dim>::setup()
{
  TimerOutput::Scope scope(log.timer(), "setup");
  space.distribute();
  assemble_region_operators(space, operators);
  constraints.build();
  for (const std::string &conflict : constraints.conflicts())
    log.warning(conflict);
  loads.build();
  history.reinit(space.velocity_vector(), velocity_nodes(operators));
  bulk_history.reinit(space.pressure_vector(), pressure_nodes(operators));
  system.reinit();
  outlets.build();
  power_ledger.reinit();
  for (DistributedVector *vector : {&balanced.velocity, &balanced.acceleration, &prescribed,
                                    &balanced.prescribed, &momentum, &velocity_work, &mixture})
    *vector = space.velocity_vector();
  for (DistributedVector *vector : {&balanced.pressure, &mass, &pressure_work, &mass_work})
    *vector = space.pressure_vector();
  StateSizes sizes(velocity_work, pressure_work);
  visit(sizes);

  // A pressure that no compressible material touches follows from the constraint alone.
  DistributedVector compressible = space.pressure_vector();
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (!problem.materials[region].is_incompressible())
    {
      pressure_work = 1.;
      multiply(operators[region].pressure_mass, mass, pressure_work);
      compressible.add(1., mass);
    }
  incompressible_pressures.clear();
  for (unsigned int i = 0; i < space.pressure_owned.n_elements(); ++i)
    if (compressible.begin()[i] == 0.)
      incompressible_pressures.push_back(i);
  // Copies are collective: a rank without such a pressure makes them, too.
  some_incompressible_pressures =
      Utilities::MPI::max(incompressible_pressures.empty() ? 0 : 1, problem.communicator) == 1;
  evaluation.rebuild();
  kept.forget();
}

template <int dim>
void TaylorHoodSolver<dim>::set_coefficients(const Step &step)
{
  coefficients.mass.clear();
  coefficients.stiffness.clear();
  coefficients.compressibility.clear();
  for (const Material &material : problem.materials)
  {
    coefficients.mass.push_back(step.a0 * material.density);
    coefficients.stiffness.push_back(material.shear.viscosity +
                                     BranchHistory::step_stiffness(material, step));
    coefficients.compressibility.push_back(BulkHistory::step_compressibility(material, step));
  }
}

template <int dim>
void TaylorHoodSolver<dim>::report_exponential_branches(const Step &step)
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

template <int dim>
void TaylorHoodSolver<dim>::report_linear_solver()
{
  const std::string text = std::string("Linear solver: ") +
                           (system.is_direct() ? "direct" : "iterative") + ", as " +
                           system.reason();
  if (text == linear_solver_reported)
    return;
  linear_solver_reported = text;
  if (system.is_direct() || !system.is_automatic())
    log.detail(text);
  else
    log.line(text);
  log.detail(system.name());
  if (system.library_depends_on_ranks())
    log.detail("The library of a factor depends on the number of ranks: CHOLMOD works on one rank "
               "only");
}

template <int dim>
StepReport TaylorHoodSolver<dim>::advance(const Step &step)
{
  StepReport report;
  kept.move_older_level(step);
  {
    TimerOutput::Scope scope(log.timer(), "factor");
    set_coefficients(step);
    const bool is_new = system.prepare(coefficients);
    report.factored = system.has_new_factor();
    if (is_new)
    {
      report_linear_solver();
      outlets.respond(system);
    }
  }
  if (report.factored)
    report_exponential_branches(step);
  {
    TimerOutput::Scope scope(log.timer(), "right-hand side");
    // Momentum: inertia of the past, force of the branches, loads.
    velocity_work.equ(-step.a1, velocity);
    if (step.a2 != 0.)
      velocity_work.add(-step.a2, velocity_older);
    balanced.acceleration.equ(-1., velocity_work);
    momentum = 0.;
    for (unsigned int region = 0; region < operators.size(); ++region)
    {
      const Material &material = problem.materials[region];
      multiply(operators[region].mass, balanced.velocity, velocity_work);
      momentum.add(material.density, balanced.velocity);
      if (history.predict(region, step, velocity, mixture))
      {
        multiply(operators[region].stiffness, balanced.velocity, mixture);
        momentum.add(-1., balanced.velocity);
      }
    }
    loads.add(step.balance_time, momentum);
    outlets.take_forces(momentum);

    // Mass: the pressure of the past.
    pressure_work.equ(step.pressure_old, pressure);
    if (step.pressure_older != 0.)
      pressure_work.add(step.pressure_older, pressure_older);
    mass = 0.;
    for (unsigned int region = 0; region < operators.size(); ++region)
    {
      const double compressibility = coefficients.compressibility[region];
      const bool relaxes = bulk_history.has(region);
      if (relaxes)
      {
        bulk_history.predict(region, step, mass_work);
        multiply(operators[region].pressure_mass, balanced.pressure, mass_work);
        mass.add(-compressibility, balanced.pressure);
      }
      else if (compressibility != 0.)
      {
        multiply(operators[region].pressure_mass, balanced.pressure, pressure_work);
        mass.add(-compressibility, balanced.pressure);
      }
      if (step.divergence_old && !relaxes)
      {
        // What relaxes has the rate of the past in its own prediction.
        multiply(operators[region].divergence, balanced.pressure, velocity);
        mass.add(1., balanced.pressure);
      }
    }

    if (!constraints.is_homogeneous())
    {
      constraints.evaluate(step.extrapolate ? step.time : step.balance_time, prescribed);
      if (step.extrapolate)
      {
        // The end of the step has what is prescribed there, so its middle the mean of that and of
        // the start.
        constraints.prescribed_part(velocity, balanced.prescribed);
        balanced.prescribed.sadd(0.5, 0.5, prescribed);
        outlets.leave_out_ports(balanced.prescribed);
      }
      else
        balanced.prescribed.equ(1., prescribed);
      balanced.velocity = 0.;
      system.add_velocity_product(balanced.prescribed, balanced.velocity);
      momentum.add(-1., balanced.velocity);
      system.add_divergence(1., balanced.prescribed, mass);
    }
    constraints.restrict_to_free(momentum);
  }
  {
    TimerOutput::Scope scope(log.timer(), "solve");
    system.solve(momentum, mass, balanced.velocity, balanced.pressure);
    constraints.set_constrained(balanced.velocity, balanced.prescribed);
    report.linear_iterations = system.take_iterations();
    outlets.couple(step, velocity, balanced.velocity, balanced.pressure);
  }
  TimerOutput::Scope scope(log.timer(), "update");
  set_extremes(step, velocity, balanced.velocity, balanced.pressure, report);
  balanced.acceleration.add(step.a0, balanced.velocity);
  history.advance(step, velocity, balanced.velocity);
  bulk_history.advance(step, balanced.pressure);
  velocity_older.swap(velocity);
  pressure_older.swap(pressure);
  if (step.extrapolate)
  {
    velocity.equ(2., balanced.velocity);
    velocity.add(-1., velocity_older);
    pressure.equ(2., balanced.pressure);
    pressure.add(-1., pressure_older);
    extrapolate_pressure(step);
  }
  else
  {
    // An assignment would build a plan of exchange between ranks.
    velocity.equ(1., balanced.velocity);
    pressure.equ(1., balanced.pressure);
  }
  if (some_incompressible_pressures)
  {
    pressure_known.equ(1., balanced.pressure);
    pressure_known_time = step.balance_time;
  }
  present_time = step.time;
  balanced.step = step;
  kept.advance(step);
  return report;
}

template <int dim>
void TaylorHoodSolver<dim>::extrapolate_pressure(const Step &step)
{
  // Where 1/K = 0 the pressure has no history: the balanced one belongs to the middle of the step,
  // and the line through the last two of them leads to its end.
  const double factor = (step.time - step.balance_time) / (step.balance_time - pressure_known_time);
  for (const unsigned int i : incompressible_pressures)
    pressure.begin()[i] = balanced.pressure.begin()[i] +
                          factor * (balanced.pressure.begin()[i] - pressure_known.begin()[i]);
}

template <int dim>
bool TaylorHoodSolver<dim>::steady_is_direct() const
{
  bool all_solid = true, all_fluid = true;
  for (const Material &material : problem.materials)
    (material.shear.branches.empty() ? all_solid : all_fluid) = false;
  return all_solid || all_fluid;
}

template <int dim>
std::unique_ptr<VibrationOperator<dim>> TaylorHoodSolver<dim>::vibration()
{
  using Vibration = TaylorHoodVibration<dim>;
  return std::make_unique<Vibration>(
      space, problem, operators, constraints, system,
      typename Vibration::State{velocity, history.displacement(), pressure});
}

template <int dim>
void TaylorHoodSolver<dim>::solve_steady(const double time)
{
  AssertThrow(steady_is_direct(), ExcInternalError());
  // A solid at rest: displacement for velocity, mu for alpha, 1/K for compressibility. A steady
  // fluid has no dp/dt, so its compressibility plays no part.
  const bool solid = !problem.materials.front().shear.branches.empty();
  SystemCoefficients steady;
  for (const Material &material : problem.materials)
  {
    steady.mass.push_back(0.);
    steady.stiffness.push_back(solid ? material.long_term_shear_modulus()
                                     : material.shear.viscosity);
    steady.compressibility.push_back(solid ? material.long_term_inverse_bulk_modulus() : 0.);
  }
  {
    TimerOutput::Scope scope(log.timer(), "factor");
    const bool is_new = system.prepare(steady);
    if (is_new)
      report_linear_solver();
    if (is_new && !solid)
      outlets.respond(system);
  }
  momentum = 0.;
  mass = 0.;
  loads.add(time, momentum);
  outlets.take_forces(momentum);
  balanced.prescribed = 0.;
  // A solid at rest has no velocity to prescribe: its supports hold.
  if (!solid && !constraints.is_homogeneous())
  {
    constraints.evaluate(time, prescribed);
    balanced.prescribed.equ(1., prescribed);
    balanced.velocity = 0.;
    system.add_velocity_product(balanced.prescribed, balanced.velocity);
    momentum.add(-1., balanced.velocity);
    system.add_divergence(1., balanced.prescribed, mass);
  }
  constraints.restrict_to_free(momentum);
  {
    TimerOutput::Scope scope(log.timer(), "solve");
    system.solve(momentum, mass, velocity_work, pressure);
  }
  constraints.set_constrained(velocity_work, balanced.prescribed);
  // Nothing flows out of a solid at rest.
  if (!solid)
    outlets.couple_steady(time, velocity_work, pressure);
  if (!std::isfinite(velocity_work.linfty_norm()))
    throw RunError("the steady solution is not finite");
  (solid ? history.displacement() : velocity).equ(1., velocity_work);
  present_time = time;
}

template <int dim>
StepError TaylorHoodSolver<dim>::step_error()
{
  StepError error;
  error.is_known = kept.error_is_known();
  if (!error.is_known)
    return error;
  TimerOutput::Scope scope(log.timer(), "step error");
  kept.velocity_error(velocity.begin(), velocity_work.begin(), velocity.locally_owned_size());
  // Prescribed velocities are exact, whatever is predicted of them.
  mixture = 0.;
  constraints.set_constrained(velocity_work, mixture);
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    multiply(operators[region].mass, momentum, velocity_work);
    error.kinetic_energy += 0.5 * problem.materials[region].density * (velocity_work * momentum);
  }
  return error;
}

template <int dim>
void TaylorHoodSolver<dim>::keep_state()
{
  TimerOutput::Scope scope(log.timer(), "step error");
  kept.keep();
}

template <int dim>
void TaylorHoodSolver<dim>::return_to_kept_state()
{
  kept.give_back();
}

template <int dim>
void TaylorHoodSolver<dim>::visit(StateVisitor &visitor)
{
  visitor.levels("velocity", StateKind::velocity, velocity, velocity_older);
  visitor.levels("pressure", StateKind::pressure, pressure, pressure_older);
  history.visit(visitor);
  bulk_history.visit(visitor);
  outlets.visit(visitor);
  visitor.vector("known pressure", StateKind::pressure, pressure_known);
  visitor.value("time of the known pressure", pressure_known_time);
  visitor.value("present time", present_time);
}

template <int dim>
bool TaylorHoodSolver<dim>::data_jump(const double begin, const double end) const
{
  return loads.jumps(begin, end) || constraints.jumps(begin, end) || outlets.jumps(begin, end);
}

template <int dim>
State TaylorHoodSolver<dim>::state() const
{
  return State{velocity, pressure, history};
}

template <int dim>
std::vector<FieldComponent> TaylorHoodSolver<dim>::fields() const
{
  return field_names<dim>(problem.model);
}

template <int dim>
unsigned int TaylorHoodSolver<dim>::add_probe(const ProbeRequest<dim> &request)
{
  return evaluation.add(request);
}

template <int dim>
void TaylorHoodSolver<dim>::evaluate_probes(std::vector<double> &values)
{
  evaluation.evaluate(state(), values);
}

template <int dim>
PowerBalance TaylorHoodSolver<dim>::power_balance(const bool relaxation)
{
  return power_ledger.balance(balanced, history, bulk_history, relaxation);
}

template <int dim>
Energy TaylorHoodSolver<dim>::energy()
{
  return power_ledger.energy(state(), bulk_history);
}

template <int dim>
double TaylorHoodSolver<dim>::divergence()
{
  mass = 0.;
  system.add_divergence(1., velocity, mass);
  DistributedVector volume = space.pressure_vector(), one = volume;
  for (const auto index : space.pressure_owned)
    if (!space.pressure_hanging.is_constrained(index))
      one[index] = 1.;
  one.compress(VectorOperation::insert);
  for (const RegionOperators &region : operators)
  {
    multiply(region.pressure_mass, pressure_work, one);
    volume.add(1., pressure_work);
  }
  double largest = 0.;
  for (unsigned int i = 0; i < mass.locally_owned_size(); ++i)
    if (one.begin()[i] > 0.)
      largest = std::max(largest, std::abs(mass.begin()[i] / volume.begin()[i]));
  return Utilities::MPI::max(largest, space.communicator);
}

template <int dim>
std::map<std::string, std::string> TaylorHoodSolver<dim>::add_output(DataOut<dim> &data_out)
{
  return output.add(state(), data_out);
}

template <int dim>
void TaylorHoodSolver<dim>::indicators(const IndicatorRequest &request, Vector<float> &per_cell)
{
  if (request.kind == IndicatorRequest::Kind::traction_jump)
    traction_jump_indicators(space, problem, evaluation, state(),
                             outlets.present_pressures(present_time, velocity), present_time,
                             per_cell);
  else if (request.field == IndicatorField::pressure)
    kelly_indicators_of_pressure(space, pressure, per_cell);
  else
    kelly_indicators_of_velocity(
        space, request.field == IndicatorField::velocity ? velocity : history.displacement(),
        per_cell);
}

template <int dim>
void TaylorHoodSolver<dim>::prepare_refinement()
{
  StateVectors vectors;
  visit(vectors);
  mesh_transfer.prepare(vectors.velocities, vectors.pressures);
}

template <int dim>
void TaylorHoodSolver<dim>::transfer()
{
  setup();
  StateVectors vectors;
  visit(vectors);
  mesh_transfer.finish(vectors.velocities, vectors.pressures);
  for ([[maybe_unused]] const DistributedVector *vector : vectors.velocities)
    Assert(have_same_layout(*vector, space.velocity_vector()), ExcInternalError());
  for ([[maybe_unused]] const DistributedVector *vector : vectors.pressures)
    Assert(have_same_layout(*vector, space.pressure_vector()), ExcInternalError());
}

template <int dim>
StateNumbering TaylorHoodSolver<dim>::numbering() const
{
  return {VectorNumbering(space.communicator, "velocity", numbers_of_dofs(space.velocity_dofs)),
          VectorNumbering(space.communicator, "pressure", numbers_of_dofs(space.pressure_dofs))};
}

template <int dim>
void TaylorHoodSolver<dim>::save(ArchiveWriter &archive) const
{
  save_state(archive, numbering(), kept);
}

template <int dim>
void TaylorHoodSolver<dim>::load(const ArchiveReader &archive)
{
  load_state(archive, numbering(), kept);
}

template <int dim>
double TaylorHoodSolver<dim>::error_norm(const std::string &field,
                                         const std::vector<Expression> &exact,
                                         const double time)
{
  return evaluation.error_norm(state(), field, exact, time);
}

template <int dim>
SolverSizes TaylorHoodSolver<dim>::sizes() const
{
  SolverSizes sizes;
  sizes.n_cells = space.triangulation.n_global_active_cells();
  sizes.n_dofs["velocity"] = space.velocity_dofs.n_dofs();
  sizes.n_dofs["pressure"] = space.pressure_dofs.n_dofs();
  if (system.factor() != nullptr)
  {
    sizes.factor_entries = system.factor()->n_entries();
    sizes.factor_memory = system.factor()->memory();
  }
  sizes.linear_solver = system.name();
  sizes.reason_of_linear_solver = system.reason();
  return sizes;
}

template class TaylorHoodSolver<2>;
template class TaylorHoodSolver<3>;
} // namespace Continua
