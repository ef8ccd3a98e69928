#include <continua/finite_volume/cell_wise_solver.h>

#include <continua/base/input_error.h>
#include <continua/continuum/state_vectors.h>
#include <continua/continuum/step_extremes.h>
#include <continua/finite_volume/cell_initial_state.h>
#include <continua/finite_volume/cell_kelly_indicator.h>
#include <continua/finite_volume/cell_traction_jump.h>
#include <continua/finite_volume/cell_vibration.h>
#include <continua/finite_volume/coupled_solve.h>
#include <continua/finite_volume/segregated_solve.h>
#include <continua/linear_algebra/matrix_product.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Continua
{
using namespace dealii;

namespace
{
/// Solves the equations of a step; a RunError says which one.
template <int dim>
void solve_step(CellSolve<dim> &solve,
                const Step &step,
                const DistributedVector &momentum,
                const DistributedVector &mass,
                DistributedVector &velocity,
                DistributedVector &pressure,
                StepReport &report)
{
  try
  {
    solve.solve(momentum, mass, velocity, pressure, report);
  }
  catch (const RunError &error)
  {
    std::ostringstream text;
    text << "in the step to t = " << step.time << " s " << error.what();
    throw RunError(text.str());
  }
}

/// `present_time`: of the step's start, kept up to date by the solver.
template <int dim>
std::unique_ptr<CellSolve<dim>>
make_solve(const CellSystem<dim> &system, Log &log, const double &present_time)
{
  if (!system.parameters.is_segregated())
    return std::make_unique<CoupledSolve<dim>>(system);
  if (!system.parameters.residual_history)
    return std::make_unique<SegregatedSolve<dim>>(system);
  const auto tell = [&log, &present_time](const LoopCorrection &correction)
  {
    std::ostringstream text;
    text << "step from t = " << present_time << " s, correction " << correction.number
         << ": residual " << correction.residual << ", of the equation of state "
         << correction.continuity;
    log.detail(text.str());
  };
  return std::make_unique<SegregatedSolve<dim>>(system, tell);
}
} // namespace

template <int dim>
CellWiseSolver<dim>::CellWiseSolver(parallel::TriangulationBase<dim> &triangulation,
                                    const Problem &problem,
                                    const CellWiseParameters &parameters,
                                    Log &log)
    : problem(problem),
      parameters(parameters),
      formulation(parameters.formulation),
      log(log),
      space(triangulation, problem.model),
      conditions(space, problem.conditions),
      loads(space, problem, conditions),
      history(problem.materials),
      bulk_history(problem.materials),
      system(space, problem, conditions, operators, closure, this->parameters),
      solve(make_solve(system, log, present_time)),
      loaded_faces(space, problem, conditions, operators, closure, this->parameters),
      power_ledger(space, problem, this->parameters, conditions, loads, operators),
      evaluation(space, problem),
      output(space, problem, evaluation),
      cell_transfer(space, conditions, problem.conditions, evaluation.reconstruction()),
      kept([this](StateVisitor &visitor) { visit(visitor); })
{
}

template <int dim>
CellWiseSolver<dim>::~CellWiseSolver() = default;

template <int dim>
void CellWiseSolver<dim>::initialise()
{
  setup();
  present_time = pressure_known_time = 0.;
  set_initial_state();
  bulk_history.start(pressure);
  balance_faces(0.);
  velocity_older.equ(1., velocity);
  pressure_older.equ(1., pressure);
  pressure_known.equ(1., pressure);
  set_dilatation_rate();
}

template <int dim>
void CellWiseSolver<dim>::setup()
{
  TimerOutput::Scope scope(log.timer(), "setup");
  space.distribute();
  conditions.build();
  assemble_cell_operators(space, problem, conditions, parameters, operators, closure);
  loads.build();
  std::vector<std::vector<unsigned int>> velocities_of_regions, pressures_of_regions;
  for (const CellOperators &of_region : operators)
  {
    velocities_of_regions.push_back(rows_with_entries(of_region.stiffness));
    pressures_of_regions.push_back(rows_with_entries(of_region.divergence));
  }
  history.reinit(space.velocity_vector(), velocities_of_regions);
  bulk_history.reinit(space.pressure_vector(), pressures_of_regions);
  system.reinit();
  loaded_faces.reinit();
  power_ledger.reinit();
  for (DistributedVector *vector :
       {&balanced.velocity, &balanced.acceleration, &balanced.prescribed, &prescribed, &momentum,
        &velocity_work, &mixture})
    *vector = space.velocity_vector();
  for (DistributedVector *vector : {&balanced.pressure, &mass, &pressure_work, &mass_work})
    *vector = space.pressure_vector();
  StateSizes sizes(velocity_work, pressure_work);
  visit(sizes);
  smallest_distance = std::numeric_limits<double>::max();
  for (const VolumeFace<dim> &surface : space.mesh.faces())
    smallest_distance = std::min(smallest_distance, surface.distance * surface.normal);
  smallest_distance = Utilities::MPI::min(smallest_distance, space.communicator);

  // A pressure that no compressible material determines follows from the constraint alone; a
  // face's goes with its cell's.
  pressures_without_history.clear();
  std::vector<bool> has_history(space.pressures.n_owned(), false);
  for (unsigned int region = 0; region < operators.size(); ++region)
    if (!problem.materials[region].is_incompressible())
      for (unsigned int i = 0; i < has_history.size(); ++i)
        if (operators[region].pressure_volume.begin()[i] > 0.)
          has_history[i] = true;
  for (unsigned int face = 0; face < space.mesh.faces().size(); ++face)
  {
    const VolumeFace<dim> &surface = space.mesh.faces()[face];
    for (unsigned int side = 0; surface.has_value() && side < surface.n_sides(); ++side)
    {
      const FiniteVolume<dim> &cell = space.mesh.cells()[surface.cell(side)];
      if (cell.is_owned && !problem.materials[cell.material_id].is_incompressible())
        has_history[space.local_pressure(space.pressures.of_face(face, side))] = true;
    }
  }
  for (unsigned int i = 0; i < has_history.size(); ++i)
    if (!has_history[i])
      pressures_without_history.push_back(i);
  // Copies are collective: a rank without such a pressure makes them, too.
  some_pressures_without_history =
      Utilities::MPI::max(pressures_without_history.empty() ? 0 : 1, problem.communicator) == 1;
  evaluation.build();
  kept.forget();
}

template <int dim>
Step CellWiseSolver<dim>::with_pressure_update(const Step &step) const
{
  Step result = step;
  if (parameters.pressure_update == PressureUpdate::as_displacement || step.extrapolate)
    return result;
  const bool trapezoidal = parameters.pressure_update == PressureUpdate::trapezoidal;
  result.pressure_time = (trapezoidal ? 0.5 : 1.) * step.size();
  result.pressure_old = 1.;
  result.pressure_older = 0.;
  result.divergence_old = trapezoidal;
  return result;
}

namespace
{
/// What a solid's increment correction is measured by: 2 mu + lambda; where the stencil does not
/// have that for its own coefficient no more than 4 mu, since the correction would fade away as the
/// solid becomes incompressible [Pa].
double correction_modulus(const Material &material, const CellWiseParameters &parameters)
{
  const double mu = material.instantaneous_shear_modulus();
  const double inverse_bulk = material.inverse_bulk_modulus();
  const bool is_nearly_incompressible = inverse_bulk * 8. / 3. * mu < 1.;
  return is_nearly_incompressible &&
                 parameters.stencil_coefficient != StencilCoefficient::longitudinal
             ? 4. * mu
             : 4. / 3. * mu + 1. / inverse_bulk;
}
} // namespace

template <int dim>
CellCoefficients CellWiseSolver<dim>::coefficients(const Step &step) const
{
  CellCoefficients result;
  result.with_pressure = parameters.has_pressure();
  result.correct_fluxes =
      formulation == Formulation::velocity_pressure && parameters.rhie_chow != RhieChow::none;
  for (const Material &material : problem.materials)
  {
    result.mass.push_back(step.a0 * material.density);
    // A fluid without viscosity gets next to none, so that its faces have an equation for the
    // motion along them.
    const double least = 1e-12 * step.a0 * material.density * smallest_distance * smallest_distance;
    result.stiffness.push_back(
        std::max(material.shear.viscosity + BranchHistory::step_stiffness(material, step), least));
    result.compressibility.push_back(BulkHistory::step_compressibility(material, step));
    const bool of_increment =
        parameters.rhie_chow == RhieChow::increment && !material.shear.branches.empty();
    result.increment_mobility.push_back(
        of_increment ? 1. / (correction_modulus(material, parameters) * step.pressure_time) : 0.);
  }
  return result;
}

template <int dim>
CellCoefficients CellWiseSolver<dim>::steady_coefficients() const
{
  // A solid at rest: displacement for velocity, mu for alpha, 1/K for compressibility. A steady
  // fluid has no dp/dt, so its compressibility plays no part.
  const bool solid = !problem.materials.front().shear.branches.empty();
  CellCoefficients result;
  result.with_pressure = parameters.has_pressure();
  result.correct_fluxes =
      formulation == Formulation::velocity_pressure && parameters.rhie_chow != RhieChow::none;
  for (const Material &material : problem.materials)
  {
    result.mass.push_back(0.);
    result.stiffness.push_back(solid ? material.long_term_shear_modulus()
                                     : material.shear.viscosity);
    result.compressibility.push_back(solid ? material.long_term_inverse_bulk_modulus() : 0.);
    result.increment_mobility.push_back(solid && parameters.rhie_chow == RhieChow::increment
                                            ? 1. / correction_modulus(material, parameters)
                                            : 0.);
  }
  return result;
}

template <int dim>
bool CellWiseSolver<dim>::prepare(const CellCoefficients &coefficients)
{
  TimerOutput::Scope scope(log.timer(), "factor");
  if (!system.prepare(coefficients))
    return false;
  solve->reinit();
  return true;
}

template <int dim>
void CellWiseSolver<dim>::report_exponential_branches(const Step &step)
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
void CellWiseSolver<dim>::add_history(const Step &step)
{
  velocity_work.equ(-step.a1, velocity);
  if (step.a2 != 0.)
    velocity_work.add(-step.a2, velocity_older);
  balanced.acceleration.equ(-1., velocity_work);
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const CellOperators &of_region = operators[region];
    const double density = problem.materials[region].density;
    for (unsigned int i = 0; i < momentum.locally_owned_size(); ++i)
      momentum.begin()[i] += density * of_region.volume.begin()[i] * velocity_work.begin()[i];
    if (history.predict(region, step, velocity, mixture))
    {
      multiply(parameters.accumulated_term == AccumulatedTerm::inconsistent
                   ? of_region.wide_stiffness
                   : of_region.stiffness,
               balanced.velocity, mixture);
      momentum.add(-1., balanced.velocity);
    }
  }
}

template <int dim>
void CellWiseSolver<dim>::add_state(const Step &step)
{
  pressure_work.equ(step.pressure_old, pressure);
  if (step.pressure_older != 0.)
    pressure_work.add(step.pressure_older, pressure_older);
  const CellCoefficients &present = system.coefficients();
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const DistributedVector &volume = operators[region].pressure_volume;
    const bool relaxes = bulk_history.has(region);
    if (relaxes)
      bulk_history.predict(region, step, pressure_work);
    for (unsigned int i = 0; i < mass.locally_owned_size(); ++i)
      if (volume.begin()[i] != 0.)
      {
        mass.begin()[i] +=
            present.compressibility[region] * volume.begin()[i] * pressure_work.begin()[i];
        // What relaxes has the rate of the past in its own prediction.
        if (step.divergence_old && !relaxes)
          mass.begin()[i] -= dilatation_rate.begin()[i];
      }
  }
  system.add_increment_correction(-1., pressure_work, mass);
}

template <int dim>
void CellWiseSolver<dim>::set_prescribed(const Step &step)
{
  if (conditions.is_homogeneous())
    balanced.prescribed = 0.;
  else
  {
    conditions.evaluate(step.extrapolate ? step.time : step.balance_time, prescribed);
    if (step.extrapolate)
    {
      // The end of the step has what is prescribed there, so its middle the mean of that and of the
      // start.
      conditions.prescribed_part(velocity, balanced.prescribed);
      balanced.prescribed.sadd(0.5, 0.5, prescribed);
    }
    else
      balanced.prescribed.equ(1., prescribed);
  }
  system.set_prescribed(balanced.prescribed, momentum);
}

template <int dim>
StepReport CellWiseSolver<dim>::advance(const Step &given_step)
{
  if (formulation == Formulation::displacement)
    return advance_displacement(given_step);
  const Step step = with_pressure_update(given_step);
  if (step.extrapolate && !undamped_is_reported)
    log.warning("crank-nicolson damps nothing, and the cell-wise operator is not symmetric beside "
                "boundaries: a few of its highest modes may grow in a long run");
  undamped_is_reported = undamped_is_reported || step.extrapolate;
  StepReport report;
  kept.move_older_level(step);
  take_up_jump(step);
  report.factored = prepare(coefficients(step));
  if (report.factored)
    report_exponential_branches(step);
  {
    TimerOutput::Scope scope(log.timer(), "right-hand side");
    if (step.divergence_old && !dilatation_rate_is_current)
      set_dilatation_rate();
    momentum = 0.;
    mass = 0.;
    add_history(step);
    loads.add(step.balance_time, momentum);
    if (parameters.has_pressure())
      add_state(step);
    set_prescribed(step);
  }
  {
    TimerOutput::Scope scope(log.timer(), "solve");
    balanced.velocity.equ(1., velocity);
    balanced.pressure.equ(1., pressure);
    solve_step(*solve, step, momentum, mass, balanced.velocity, balanced.pressure, report);
  }
  TimerOutput::Scope scope(log.timer(), "update");
  set_extremes(step, velocity, balanced.velocity, balanced.pressure, report);
  balanced.acceleration.add(step.a0, balanced.velocity);
  history.advance(step, velocity, balanced.velocity);
  if (parameters.has_pressure())
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
    velocity.equ(1., balanced.velocity);
    pressure.equ(1., balanced.pressure);
  }
  if (some_pressures_without_history)
  {
    pressure_known.equ(1., balanced.pressure);
    pressure_known_time = step.balance_time;
  }
  if (step.divergence_old)
    set_dilatation_rate();
  pressure_is_current = parameters.has_pressure();
  present_time = step.time;
  balanced.step = step;
  kept.advance(step);
  return report;
}

template <int dim>
StepReport CellWiseSolver<dim>::advance_displacement(const Step &step)
{
  StepReport report;
  if (!displacement_levels.is_started())
    displacement_levels.start(history.displacement(), velocity, step.size());
  const auto derivatives = displacement_levels.derivatives(step, step.a2 != 0.);
  CellCoefficients present;
  present.with_pressure = false;
  present.correct_fluxes = false;
  for (const Material &material : problem.materials)
  {
    present.mass.push_back(derivatives.second_own * material.density);
    present.stiffness.push_back(material.long_term_shear_modulus());
  }
  report.factored = prepare(present);
  {
    TimerOutput::Scope scope(log.timer(), "right-hand side");
    momentum = 0.;
    displacement_levels.combine(derivatives.second_known, balanced.acceleration);
    for (unsigned int region = 0; region < operators.size(); ++region)
      for (unsigned int i = 0; i < momentum.locally_owned_size(); ++i)
        momentum.begin()[i] -= problem.materials[region].density *
                               operators[region].volume.begin()[i] *
                               balanced.acceleration.begin()[i];
    loads.add(step.balance_time, momentum);
    // U = own D + known levels, so that a prescribed velocity prescribes D.
    displacement_levels.combine(derivatives.first_known, velocity_work);
    if (!conditions.is_homogeneous())
      conditions.evaluate(step.balance_time, balanced.prescribed);
    mixture.equ(1. / derivatives.first_own, balanced.prescribed);
    mixture.add(-1. / derivatives.first_own, velocity_work);
    system.set_prescribed(mixture, momentum);
  }
  DistributedVector &displacement = history.displacement();
  {
    TimerOutput::Scope scope(log.timer(), "solve");
    solve_step(*solve, step, momentum, mass, displacement, pressure, report);
  }
  TimerOutput::Scope scope(log.timer(), "update");
  balanced.acceleration.add(derivatives.second_own, displacement);
  balanced.velocity.equ(1., velocity_work);
  balanced.velocity.add(derivatives.first_own, displacement);
  set_extremes(step, velocity, balanced.velocity, balanced.pressure, report);
  velocity_older.swap(velocity);
  velocity.equ(1., balanced.velocity);
  displacement_levels.advance(step, displacement);
  pressure_is_current = false;
  present_time = step.time;
  balanced.step = step;
  kept.advance(step);
  return report;
}

template <int dim>
void CellWiseSolver<dim>::extrapolate_pressure(const Step &step)
{
  // Where 1/K = 0 the pressure has no history: the balanced one belongs to the middle of the step,
  // and the line through the last two of them leads to its end.
  const double factor = (step.time - step.balance_time) / (step.balance_time - pressure_known_time);
  for (const unsigned int i : pressures_without_history)
    pressure.begin()[i] = balanced.pressure.begin()[i] +
                          factor * (balanced.pressure.begin()[i] - pressure_known.begin()[i]);
}

template <int dim>
void CellWiseSolver<dim>::set_dilatation_rate()
{
  dilatation_rate = 0.;
  for (const CellOperators &of_region : operators)
  {
    multiply(of_region.divergence, mass_work, velocity);
    dilatation_rate.add(1., mass_work);
  }
  // What Rhie and Chow's correction of a pressure lets through a face has flowed.
  system.add_pressure_correction(-1., pressure, dilatation_rate);
  dilatation_rate_is_current = true;
}

template <int dim>
void CellWiseSolver<dim>::set_pressure_of_displacement()
{
  if (parameters.has_pressure() && pressure_is_current)
    return;
  pressure = 0.;
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const CellOperators &of_region = operators[region];
    multiply(of_region.divergence, mass_work, history.displacement());
    for (unsigned int i = 0; i < mass_work.locally_owned_size(); ++i)
      if (of_region.pressure_volume.begin()[i] != 0. &&
          !problem.materials[region].is_incompressible())
        pressure.begin()[i] -= mass_work.begin()[i] / of_region.pressure_volume.begin()[i] /
                               problem.materials[region].inverse_bulk_modulus();
  }
  // Faces without an equation of state have the pressure of their cell, extrapolated.
  multiply(closure.matrix, pressure_work, pressure);
  for (const unsigned int i : closure.rows)
    pressure.begin()[i] -=
        pressure_work.begin()[i] / closure.matrix.diag_element(space.pressures.first_owned() + i);
  pressure_is_current = true;
}

template <int dim>
void CellWiseSolver<dim>::set_initial_state()
{
  const InteriorData &data = problem.interior;
  set_initial_values(space, problem, velocity, history.displacement(), pressure);
  // What is held does not move from the start on.
  if (conditions.is_homogeneous())
    conditions.clear_prescribed(velocity);
  if (!data.initial_displacement.empty() && data.initial_pressure.empty() &&
      parameters.has_pressure())
  {
    pressure_is_current = false;
    set_pressure_of_displacement();
    log.line("Initial pressure: in equilibrium with the initial displacement");
  }
}

template <int dim>
void CellWiseSolver<dim>::balance_faces(const double time)
{
  if (formulation == Formulation::displacement || !loaded_faces.exist())
    return;
  momentum = 0.;
  loads.add(time, momentum);
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const CellOperators &of_region = operators[region];
    set_mixture(state(), region, problem.materials[region], mixture);
    multiply(of_region.stiffness, velocity_work, mixture);
    momentum.add(-1., velocity_work);
    if (parameters.has_pressure())
    {
      multiply(of_region.gradient, velocity_work, pressure);
      momentum.add(-1., velocity_work);
    }
  }
  yield_to_forces();
}

template <int dim>
void CellWiseSolver<dim>::take_up_jump(const Step &step)
{
  if (step.update != Update::trapezoidal || !loaded_faces.exist() ||
      !loads.jumps(step.time_old, step.balance_time))
    return;
  // The load's change in the step, less what the step before says of its smooth part.
  momentum = 0.;
  loads.add(step.balance_time, momentum);
  velocity_work = 0.;
  loads.add(step.time_old, velocity_work);
  const double before = step.time_old - step.size();
  momentum.add(before < 0. ? -1. : -2., velocity_work);
  if (before >= 0.)
    loads.add(before, momentum);
  yield_to_forces();
}

template <int dim>
void CellWiseSolver<dim>::yield_to_forces()
{
  for (unsigned int i = 0; i < dim * space.mesh.n_owned_cells(); ++i)
    momentum.begin()[i] = 0.;
  if (momentum.linfty_norm() == 0.)
    return;
  loaded_faces.respond(momentum, velocity_work, pressure_work);
  StateVectors displacements;
  history.visit(displacements);
  for (DistributedVector *const vector : displacements.velocities)
    vector->add(1., velocity_work);
  if (!parameters.has_pressure())
    return;
  pressure.add(1., pressure_work);
  pressure_older.add(1., pressure_work);
  bulk_history.jump(pressure_work);
}

template <int dim>
bool CellWiseSolver<dim>::steady_is_direct() const
{
  bool all_solid = true, all_fluid = true;
  for (const Material &material : problem.materials)
    (material.shear.branches.empty() ? all_solid : all_fluid) = false;
  return all_solid || all_fluid;
}

template <int dim>
void CellWiseSolver<dim>::solve_steady(const double time)
{
  AssertThrow(steady_is_direct(), ExcInternalError());
  const bool solid = !problem.materials.front().shear.branches.empty();
  prepare(steady_coefficients());
  momentum = 0.;
  mass = 0.;
  loads.add(time, momentum);
  balanced.prescribed = 0.;
  // A solid at rest has no velocity to prescribe: its supports hold.
  if (!solid && !conditions.is_homogeneous())
    conditions.evaluate(time, balanced.prescribed);
  system.set_prescribed(balanced.prescribed, momentum);
  StepReport report;
  {
    TimerOutput::Scope scope(log.timer(), "solve");
    velocity_work = 0.;
    solve->solve(momentum, mass, velocity_work, pressure, report);
  }
  if (!std::isfinite(velocity_work.linfty_norm()))
    throw RunError("the steady solution is not finite");
  (solid ? history.displacement() : velocity).equ(1., velocity_work);
  pressure_is_current = parameters.has_pressure();
  present_time = time;
}

template <int dim>
std::unique_ptr<VibrationOperator<dim>> CellWiseSolver<dim>::vibration()
{
  return std::make_unique<CellVibration<dim>>(
      system, steady_coefficients(),
      typename CellVibration<dim>::State{velocity, history.displacement(), pressure});
}

template <int dim>
StepError CellWiseSolver<dim>::step_error()
{
  StepError error;
  error.is_known = kept.error_is_known();
  if (!error.is_known)
    return error;
  TimerOutput::Scope scope(log.timer(), "step error");
  kept.velocity_error(velocity.begin(), velocity_work.begin(), velocity.locally_owned_size());
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const double *const volume = operators[region].volume.begin();
    const double *const entries = velocity_work.begin();
    for (unsigned int i = 0; i < velocity_work.locally_owned_size(); ++i)
      error.kinetic_energy +=
          0.5 * problem.materials[region].density * volume[i] * entries[i] * entries[i];
  }
  error.kinetic_energy = Utilities::MPI::sum(error.kinetic_energy, space.communicator);
  return error;
}

template <int dim>
void CellWiseSolver<dim>::keep_state()
{
  TimerOutput::Scope scope(log.timer(), "step error");
  kept.keep();
}

template <int dim>
void CellWiseSolver<dim>::return_to_kept_state()
{
  kept.give_back();
}

template <int dim>
void CellWiseSolver<dim>::visit(StateVisitor &visitor)
{
  visitor.levels("velocity", StateKind::velocity, velocity, velocity_older);
  visitor.levels("pressure", StateKind::pressure, pressure, pressure_older);
  history.visit(visitor);
  bulk_history.visit(visitor);
  if (formulation == Formulation::displacement)
    displacement_levels.visit(visitor);
  visitor.vector("rate of dilatation", StateKind::pressure, dilatation_rate);
  visitor.value("rate of dilatation is current", dilatation_rate_is_current);
  visitor.vector("known pressure", StateKind::pressure, pressure_known);
  visitor.value("time of the known pressure", pressure_known_time);
  visitor.value("pressure is current", pressure_is_current);
  visitor.value("present time", present_time);
}

template <int dim>
bool CellWiseSolver<dim>::data_jump(const double begin, const double end) const
{
  return loads.jumps(begin, end) || conditions.jumps(begin, end);
}

template <int dim>
State CellWiseSolver<dim>::state() const
{
  return State{velocity, pressure, history};
}

template <int dim>
PowerBalance CellWiseSolver<dim>::power_balance(const bool relaxation)
{
  return power_ledger.balance(balanced, velocity_older, velocity, history, bulk_history,
                              relaxation);
}

template <int dim>
Energy CellWiseSolver<dim>::energy()
{
  return power_ledger.energy(state(), bulk_history);
}

template <int dim>
double CellWiseSolver<dim>::divergence()
{
  double largest = 0.;
  for (const CellOperators &of_region : operators)
  {
    multiply(of_region.divergence, mass_work, velocity);
    for (unsigned int i = 0; i < space.mesh.n_owned_cells(); ++i)
      if (of_region.pressure_volume.begin()[i] > 0.)
        largest = std::max(largest,
                           std::abs(mass_work.begin()[i] / of_region.pressure_volume.begin()[i]));
  }
  return Utilities::MPI::max(largest, space.communicator);
}

template <int dim>
std::vector<FieldComponent> CellWiseSolver<dim>::fields() const
{
  return field_names<dim>(problem.model);
}

template <int dim>
unsigned int CellWiseSolver<dim>::add_probe(const ProbeRequest<dim> &request)
{
  return evaluation.add(request);
}

template <int dim>
void CellWiseSolver<dim>::evaluate_probes(std::vector<double> &values)
{
  set_pressure_of_displacement();
  evaluation.evaluate(state(), values);
}

template <int dim>
std::map<std::string, std::string> CellWiseSolver<dim>::add_output(DataOut<dim> &data_out)
{
  set_pressure_of_displacement();
  return output.add(state(), data_out);
}

template <int dim>
void CellWiseSolver<dim>::indicators(const IndicatorRequest &request, Vector<float> &per_cell)
{
  set_pressure_of_displacement();
  const LinearReconstruction<dim> &reconstruction = evaluation.reconstruction();
  if (request.kind == IndicatorRequest::Kind::traction_jump)
    traction_jump_indicators(space, problem, evaluation, conditions, state(), present_time,
                             per_cell);
  else if (request.field == IndicatorField::pressure)
    kelly_indicators_of_pressure(space, reconstruction, pressure, per_cell);
  else
    kelly_indicators_of_velocity(
        space, reconstruction,
        request.field == IndicatorField::velocity ? velocity : history.displacement(), per_cell);
}

template <int dim>
void CellWiseSolver<dim>::prepare_refinement()
{
  StateVectors vectors;
  visit(vectors);
  cell_transfer.prepare(vectors.velocities, vectors.pressures);
}

template <int dim>
void CellWiseSolver<dim>::transfer()
{
  setup();
  StateVectors vectors;
  visit(vectors);
  cell_transfer.finish(vectors.velocities, vectors.pressures);
  pressure_is_current = parameters.has_pressure();
  balance_faces(present_time);
  // The flux corrections of the new mesh belong to the next step's equations.
  dilatation_rate_is_current = false;
}

template <int dim>
double CellWiseSolver<dim>::error_norm(const std::string &field,
                                       const std::vector<Expression> &exact,
                                       const double time)
{
  set_pressure_of_displacement();
  return evaluation.error_norm(state(), field, exact, time);
}

template <int dim>
StateNumbering CellWiseSolver<dim>::numbering() const
{
  return {VectorNumbering(space.communicator, "velocity", space.velocities.numbers(dim)),
          VectorNumbering(space.communicator, "pressure", space.pressures.numbers(1))};
}

template <int dim>
void CellWiseSolver<dim>::save(ArchiveWriter &archive) const
{
  save_state(archive, numbering(), kept);
}

template <int dim>
void CellWiseSolver<dim>::load(const ArchiveReader &archive)
{
  load_state(archive, numbering(), kept);
}

template <int dim>
SolverSizes CellWiseSolver<dim>::sizes() const
{
  SolverSizes sizes;
  sizes.n_cells = space.mesh.triangulation.n_global_active_cells();
  sizes.n_dofs[formulation == Formulation::displacement ? "displacement" : "velocity"] =
      dim * space.velocities.n_values();
  if (parameters.has_pressure())
    sizes.n_dofs["pressure"] = space.pressures.n_values();
  sizes.factor_entries = solve->factor_entries();
  sizes.factor_memory = solve->factor_memory();
  sizes.linear_solver = solve->name();
  return sizes;
}

template class CellWiseSolver<2>;
template class CellWiseSolver<3>;
} // namespace Continua
