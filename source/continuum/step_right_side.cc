#include <continua/continuum/step_right_side.h>

namespace Continua
{
StepRightSide::StepRightSide(const Problem &problem,
                             Operators &operators,
                             const BranchHistory &history,
                             BulkHistory &bulk_history,
                             OutletCoupling &outlets,
                             LevelProducts &products,
                             const StateLevels &levels)
    : problem(problem),
      operators(operators),
      history(history),
      bulk_history(bulk_history),
      outlets(outlets),
      products(products),
      levels(levels)
{
}

void StepRightSide::reinit(const DistributedVector &zero_velocity,
                           const DistributedVector &zero_pressure)
{
  for (DistributedVector *vector :
       {&momentum_rows, &prescribed, &velocity_work, &velocity_product, &mixture})
    vector->reinit(zero_velocity);
  for (DistributedVector *vector :
       {&mass_rows, &pressure_work, &pressure_product, &relaxed_pressure})
    vector->reinit(zero_pressure);
}

void StepRightSide::set(const Step &step,
                        const SystemCoefficients &coefficients,
                        const State &present,
                        StepSolution &solution)
{
  set_momentum(step, solution.acceleration);
  set_mass(step, coefficients, present);
  if (!operators.prescribed().is_homogeneous())
    set_prescribed(step, solution.prescribed);
}

void StepRightSide::set_momentum(const Step &step, DistributedVector &acceleration)
{
  // Inertia of the past, forces of the branches and of the supports, loads.
  velocity_work.equ(-step.a1, levels.velocity);
  if (step.a2 != 0.)
    velocity_work.add(-step.a2, levels.velocity_older);
  acceleration.equ(-1., velocity_work);
  momentum_rows = 0.;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    if (operators.has_all_terms_in(region))
      continue;
    const double density = problem.materials[region].density;
    if (products.has(region))
      momentum_rows.add(density, products.past_inertia(region, step));
    else
    {
      operators.products().multiply_mass(region, velocity_product, velocity_work);
      momentum_rows.add(density, velocity_product);
    }
    if (products.is_elastic(region))
      products.add_past_stress(region, step, momentum_rows);
    else if (history.predict(region, step, levels.velocity, mixture))
    {
      operators.variant().multiply_past_stiffness(region, velocity_product, mixture);
      momentum_rows.add(-1., velocity_product);
    }
  }
  if (problem.has_supports() && !step.finds_unloaded_shape)
    add_supports(step);
  add_loads(step);
  outlets.take_forces(momentum_rows);
}

void StepRightSide::add_supports(const Step &step)
{
  history.predict_displacement(step, levels.velocity, mixture);
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    operators.products().multiply_support_stiffness(region, velocity_product, mixture);
    momentum_rows.add(-1., velocity_product);
  }
}

void StepRightSide::add_loads(const Step &step)
{
  if (step.load_factor == 1.)
  {
    operators.loads().add(step.balance_time, momentum_rows);
    return;
  }
  velocity_work = 0.;
  operators.loads().add(step.balance_time, velocity_work);
  momentum_rows.add(step.load_factor, velocity_work);
}

void StepRightSide::set_mass(const Step &step,
                             const SystemCoefficients &coefficients,
                             const State &present)
{
  mass_rows = 0.;
  if (!operators.variant().has_pressure())
    return;
  // The pressure of the past.
  pressure_work.equ(step.pressure_old, levels.pressure);
  if (step.pressure_older != 0.)
    pressure_work.add(step.pressure_older, levels.pressure_older);
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
  {
    const double compressibility = coefficients.compressibility[region];
    if (operators.has_all_terms_in(region))
      continue;
    const bool relaxes = bulk_history.has(region);
    if (relaxes)
      bulk_history.predict(region, step, relaxed_pressure);
    if (relaxes || compressibility != 0.)
    {
      operators.products().multiply_pressure_mass(region, pressure_product,
                                                  relaxes ? relaxed_pressure : pressure_work);
      mass_rows.add(compressibility, pressure_product);
    }
    if (step.divergence_old && !relaxes)
    {
      // What relaxes has the rate of the past in its own prediction.
      if (products.has(region))
        mass_rows.add(-1., products.divergence(region));
      else
      {
        operators.variant().set_past_dilatation(region, present, pressure_product);
        mass_rows.add(-1., pressure_product);
      }
    }
  }
  if (!operators.variant().corrects_fluxes())
    return;
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (bulk_history.has(region))
      bulk_history.predict(region, step, pressure_work);
  operators.variant().add_past_flux_correction(pressure_work, mass_rows);
}

const DistributedVector &StepRightSide::prescribed_at(const double time)
{
  operators.prescribed().evaluate(time, prescribed);
  return prescribed;
}

void StepRightSide::set_prescribed(const Step &step, DistributedVector &of_step)
{
  prescribed_at(step.extrapolate ? step.time : step.balance_time);
  if (!step.extrapolate)
  {
    of_step.equ(step.load_factor, prescribed);
    return;
  }
  // The end of the step has what is prescribed there, so its middle the mean of that and of the
  // start.
  operators.prescribed().prescribed_part(levels.velocity, of_step);
  of_step.sadd(0.5, 0.5, prescribed);
  outlets.leave_out_ports(of_step);
}
} // namespace Continua
