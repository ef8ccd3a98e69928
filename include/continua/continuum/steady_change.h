#ifndef continua_continuum_steady_change_h
#define continua_continuum_steady_change_h

#include <continua/continuum/operators.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/step_solution.h>

namespace Continua
{
/// How far a step of a steady search has moved the state, see StepReport::steady_change.
class SteadyChange
{
public:
  /// Both must outlive it.
  SteadyChange(const Problem &problem, Operators &operators);

  /// Of a step that is solved and not finished, from this velocity and displacement of the solids,
  /// by region as a part of the displacement [m] of solids or of the forces [N] of liquids: the
  /// largest [1]. Collective.
  double operator()(const Step &step,
                    const DistributedVector &velocity,
                    const DistributedVector &displacement,
                    const StepSolution &solution);

private:
  const Problem &problem;
  Operators &operators;
  DistributedVector change_of_velocity, forces, inertia; ///< work space

  /// The largest viscous and inertial force of a velocity in a region [N]. Collective.
  double force_of(unsigned int region, const Step &step, const DistributedVector &velocity);
};
} // namespace Continua

#endif
