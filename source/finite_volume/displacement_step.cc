#include <continua/finite_volume/displacement_step.h>

namespace Continua
{
using namespace dealii;

template <int dim>
DisplacementStep<dim>::DisplacementStep(const CellWiseSystem<dim> &system,
                                        const CellWiseLoads<dim> &loads)
    : system(system), loads(loads)
{
}

template <int dim>
void DisplacementStep<dim>::reinit()
{
  momentum = system.space.velocity_vector();
  for (DistributedVector *vector : {&known_velocity, &work})
    vector->reinit(momentum);
  // The form has no pressure.
  mass = system.space.pressure_vector();
}

template <int dim>
CellWiseCoefficients DisplacementStep<dim>::coefficients(const Derivatives &derivatives) const
{
  CellWiseCoefficients result;
  result.with_pressure = false;
  result.correct_fluxes = false;
  for (const Material &material : system.problem.materials)
  {
    result.mass.push_back(derivatives.second_own * material.density);
    result.stiffness.push_back(material.long_term_shear_modulus());
  }
  return result;
}

template <int dim>
void DisplacementStep<dim>::set_right_side(const Step &step,
                                           const DisplacementLevels &levels,
                                           const Derivatives &derivatives,
                                           StepSolution &solution)
{
  momentum = 0.;
  levels.combine(derivatives.second_known, solution.acceleration);
  for (unsigned int region = 0; region < system.operators.size(); ++region)
    for (unsigned int i = 0; i < momentum.locally_owned_size(); ++i)
      momentum.begin()[i] -= system.problem.materials[region].density *
                             system.operators[region].volume.begin()[i] *
                             solution.acceleration.begin()[i];
  loads.add(step.balance_time, momentum);
  // U = own D + known levels, so that a prescribed velocity prescribes D.
  levels.combine(derivatives.first_known, known_velocity);
  if (!system.conditions.is_homogeneous())
    system.conditions.evaluate(step.balance_time, solution.prescribed);
  work.equ(1. / derivatives.first_own, solution.prescribed);
  work.add(-1. / derivatives.first_own, known_velocity);
  system.set_prescribed(work, momentum);
}

template <int dim>
void DisplacementStep<dim>::solve(CellWiseSolve<dim> &cell_solve,
                                  const Derivatives &derivatives,
                                  DistributedVector &displacement,
                                  StepSolution &solution,
                                  StepReport &report)
{
  cell_solve.solve(momentum, mass, displacement, solution.pressure, report);
  solution.acceleration.add(derivatives.second_own, displacement);
  solution.velocity.equ(1., known_velocity);
  solution.velocity.add(derivatives.first_own, displacement);
}

template class DisplacementStep<2>;
template class DisplacementStep<3>;
} // namespace Continua
