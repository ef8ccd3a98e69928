#include <continua/finite_volume/cell_wise_step_variant.h>

#include <continua/continuum/branch_history.h>
#include <continua/linear_algebra/matrix_product.h>

namespace Continua
{
using namespace dealii;

template <int dim>
CellWiseStepVariant<dim>::CellWiseStepVariant(const Problem &problem,
                                              const FaceConditions<dim> &conditions,
                                              const CellWiseLoads<dim> &loads,
                                              const std::vector<CellWiseOperators> &operators,
                                              const PressureClosure &closure,
                                              const CellWiseProducts<dim> &products,
                                              CellWiseSystem<dim> &system,
                                              CellWiseLinearSystem<dim> &linear_system,
                                              ExcessVelocity<dim> &excess_velocity,
                                              Log &log)
    : StepVariant(products),
      problem(problem),
      space(system.space),
      parameters(system.parameters),
      operators(operators),
      closure(closure),
      system(system),
      linear_system(linear_system),
      excess_velocity(excess_velocity),
      log(log),
      loaded_faces(space, problem, conditions, operators, closure, parameters),
      displacement_step(system, loads)
{
}

template <int dim>
void CellWiseStepVariant<dim>::reinit()
{
  loaded_faces.reinit();
  displacement_step.reinit();
  velocity_work = space.velocity_vector();
  pressure_work = space.pressure_vector();
}

template <int dim>
Step CellWiseStepVariant<dim>::adapted(const Step &step)
{
  linear_system.begin_step(step.time);
  present_step = step;
  if (solves_for_displacement())
    return step;
  if (step.extrapolate && !undamped_is_reported)
    log.warning("crank-nicolson damps nothing, and the cell-wise operator is not symmetric beside "
                "boundaries: a few of its highest modes may grow in a long run");
  undamped_is_reported = undamped_is_reported || step.extrapolate;
  Step result = step;
  if (parameters.pressure_update == PressureUpdate::as_displacement || step.extrapolate ||
      step.finds_steady_state)
    return result;
  const bool trapezoidal = parameters.pressure_update == PressureUpdate::trapezoidal;
  result.pressure_time = (trapezoidal ? 0.5 : 1.) * step.size();
  result.pressure_old = 1.;
  result.pressure_older = 0.;
  result.divergence_old = trapezoidal;
  return result;
}

template <int dim>
void CellWiseStepVariant<dim>::multiply_past_stiffness(const unsigned int region,
                                                       DistributedVector &force,
                                                       const DistributedVector &mixture)
{
  multiply(parameters.accumulated_term == AccumulatedTerm::inconsistent
               ? operators[region].wide_stiffness
               : operators[region].stiffness,
           force, mixture);
}

template <int dim>
void CellWiseStepVariant<dim>::set_past_dilatation(const unsigned int region,
                                                   const State &start,
                                                   DistributedVector &rate)
{
  if (!dilatation_rate_is_current)
    set_dilatation_rate(start);
  const double *const volume = operators[region].pressure_volume.begin();
  for (unsigned int i = 0; i < rate.locally_owned_size(); ++i)
    rate.begin()[i] = volume[i] != 0. ? dilatation_rate.begin()[i] : 0.;
}

template <int dim>
void CellWiseStepVariant<dim>::add_past_flux_correction(const DistributedVector &pressure,
                                                        DistributedVector &mass)
{
  system.add_increment_correction(-1., pressure, mass);
  if (excess_velocity.exists())
    excess_velocity.add_past(present_step, mass);
}

template <int dim>
bool CellWiseStepVariant<dim>::has_massless_velocities() const
{
  return !solves_for_displacement() && loaded_faces.exist();
}

template <int dim>
bool CellWiseStepVariant<dim>::deform_at_once(DistributedVector &forces,
                                              DistributedVector &displacement,
                                              DistributedVector &pressure)
{
  for (unsigned int i = 0; i < dim * space.mesh.n_owned_cells(); ++i)
    forces.begin()[i] = 0.;
  if (forces.linfty_norm() == 0.)
    return false;
  loaded_faces.respond(forces, displacement, pressure);
  if (!parameters.has_pressure())
    pressure = 0.;
  return true;
}

template <int dim>
void CellWiseStepVariant<dim>::complete_pressure(const DistributedVector &displacement,
                                                 DistributedVector &pressure)
{
  if (!parameters.has_pressure())
    set_pressure_of_displacement(displacement, pressure);
}

template <int dim>
void CellWiseStepVariant<dim>::set_pressure_of_displacement(const DistributedVector &displacement,
                                                            DistributedVector &pressure)
{
  pressure = 0.;
  for (unsigned int region = 0; region < operators.size(); ++region)
  {
    const CellWiseOperators &of_region = operators[region];
    multiply(of_region.divergence, pressure_work, displacement);
    for (unsigned int i = 0; i < pressure_work.locally_owned_size(); ++i)
      if (of_region.pressure_volume.begin()[i] != 0. &&
          !problem.materials[region].is_incompressible())
        pressure.begin()[i] -= pressure_work.begin()[i] / of_region.pressure_volume.begin()[i] /
                               problem.materials[region].inverse_bulk_modulus();
  }
  // Faces without an equation of state have the pressure of their cell, extrapolated.
  multiply(closure.matrix, pressure_work, pressure);
  for (const unsigned int i : closure.rows)
    pressure.begin()[i] -=
        pressure_work.begin()[i] / closure.matrix.diag_element(space.pressures.first_owned() + i);
}

template <int dim>
void CellWiseStepVariant<dim>::make_displacement_step(const Step &step,
                                                      const DistributedVector &velocity,
                                                      DistributedVector &displacement,
                                                      StepSolution &solution,
                                                      StepReport &report)
{
  if (!displacement_levels.is_started())
    displacement_levels.start(displacement, velocity, step.size());
  const auto derivatives = displacement_levels.derivatives(step, step.a2 != 0.);
  {
    SectionTimer::Scope scope(log.timer(), "factor");
    if (linear_system.prepare_cells(displacement_step.coefficients(derivatives)) ==
        SystemChange::factor)
      ++report.factors;
  }
  {
    SectionTimer::Scope scope(log.timer(), "right-hand side");
    displacement_step.set_right_side(step, displacement_levels, derivatives, solution);
  }
  SectionTimer::Scope scope(log.timer(), "solve");
  displacement_step.solve(linear_system.cell_solve(), derivatives, displacement, solution, report);
  displacement_levels.advance(step, displacement);
}

template <int dim>
void CellWiseStepVariant<dim>::set_reported_stress_force(const unsigned int region,
                                                         const StepSolution &step,
                                                         DistributedVector &mixture,
                                                         DistributedVector &force)
{
  const CellWiseOperators &of_region = operators[region];
  if (parameters.power_operator == PowerOperator::wide)
    multiply(of_region.wide_stiffness, force, mixture);
  else if (parameters.power_operator == PowerOperator::scheme &&
           parameters.accumulated_term == AccumulatedTerm::inconsistent)
  {
    // What the step has added to the mixture acts by the narrow stencil, the past by the wide one.
    const double own = BranchHistory::step_stiffness(problem.materials[region], step.step);
    mixture.add(-own, step.velocity);
    multiply(of_region.stiffness, force, step.velocity);
    force *= own;
    multiply(of_region.wide_stiffness, velocity_work, mixture);
    force.add(1., velocity_work);
  }
  else
    multiply(of_region.stiffness, force, mixture);
}

template <int dim>
void CellWiseStepVariant<dim>::visit(StateVisitor &visitor)
{
  if (solves_for_displacement())
    displacement_levels.visit(visitor);
  visitor.vector("rate of dilatation", StateKind::pressure, dilatation_rate);
  visitor.value("rate of dilatation is current", dilatation_rate_is_current);
  if (excess_velocity.exists())
    excess_velocity.visit(visitor);
}

template <int dim>
void CellWiseStepVariant<dim>::finish_step(const StepSolution &solution, const State &state)
{
  if (excess_velocity.exists())
    excess_velocity.advance(solution.step, solution.pressure);
  if (solution.step.divergence_old && !solves_for_displacement())
    set_dilatation_rate(state);
}

template <int dim>
void CellWiseStepVariant<dim>::set_dilatation_rate(const State &state)
{
  dilatation_rate = 0.;
  for (const CellWiseOperators &of_region : operators)
  {
    multiply(of_region.divergence, pressure_work, state.velocity);
    dilatation_rate.add(1., pressure_work);
  }
  // What Rhie and Chow's correction of a pressure lets through a face has flowed.
  system.add_pressure_correction(-1., state.pressure, dilatation_rate);
  if (excess_velocity.exists())
    excess_velocity.add_outflow(state.pressure, dilatation_rate);
  dilatation_rate_is_current = true;
}

template class CellWiseStepVariant<2>;
template class CellWiseStepVariant<3>;
} // namespace Continua
