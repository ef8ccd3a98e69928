#include <continua/continuum/massless_motion.h>

#include <continua/continuum/state_vectors.h>

namespace Continua
{
MasslessMotion::MasslessMotion(const Problem &problem,
                               Operators &operators,
                               BranchHistory &history,
                               BulkHistory &bulk_history,
                               OutletCoupling &outlets,
                               LevelProducts &products,
                               StateLevels &levels)
    : problem(problem),
      operators(operators),
      history(history),
      bulk_history(bulk_history),
      outlets(outlets),
      products(products),
      levels(levels)
{
}

void MasslessMotion::reinit(const DistributedVector &zero_velocity,
                            const DistributedVector &zero_pressure)
{
  if (!operators.variant().has_massless_velocities())
    return;
  for (DistributedVector *vector : {&forces, &velocity_work, &mixture})
    vector->reinit(zero_velocity);
  pressure_work.reinit(zero_pressure);
}

void MasslessMotion::deform_by_imbalance(const double time, const State &present)
{
  if (!operators.variant().has_massless_velocities())
    return;
  forces = 0.;
  operators.loads().add(time, forces);
  outlets.add_present_forces(time, levels.velocity, forces);
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    set_mixture(present, region, problem.materials[region], mixture);
    operators.products().multiply_stiffness(region, velocity_work, mixture);
    forces.add(-1., velocity_work);
    operators.products().multiply_gradient(region, velocity_work, levels.pressure);
    forces.add(-1., velocity_work);
  }
  deform();
}

void MasslessMotion::deform_by_jump(const Step &step)
{
  if (step.update != Update::trapezoidal || !operators.variant().has_massless_velocities() ||
      !operators.loads().jumps(step.time_old, step.balance_time))
    return;
  // The load's change in the step, less what the step before says of its smooth part.
  forces = 0.;
  operators.loads().add(step.balance_time, forces);
  velocity_work = 0.;
  operators.loads().add(step.time_old, velocity_work);
  const double before = step.time_old - step.size();
  forces.add(before < 0. ? -1. : -2., velocity_work);
  if (before >= 0.)
    operators.loads().add(before, forces);
  deform();
}

void MasslessMotion::deform()
{
  if (!operators.variant().deform_at_once(forces, velocity_work, pressure_work))
    return;
  StateVectors displacements;
  history.visit(displacements);
  for (DistributedVector *const vector : displacements.velocities)
    vector->add(1., velocity_work);
  levels.pressure.add(1., pressure_work);
  levels.pressure_older.add(1., pressure_work);
  bulk_history.jump(pressure_work);
  products.forget();
}
} // namespace Continua
