#include <continua/continuum/state_levels.h>

namespace Continua
{
void StateLevels::forget_older()
{
  velocity_older.equ(1., velocity);
  pressure_older.equ(1., pressure);
}

void StateLevels::extrapolate_velocity(const Step &step,
                                       const bool is_of_scheme,
                                       DistributedVector &result) const
{
  double extrapolation = 0.;
  if (!step.is_start && step.extrapolate)
    extrapolation =
        is_of_scheme && step.older_distance > 0. ? 0.5 * step.size() / step.older_distance : 0.5;
  else if (!step.is_start && step.a2 != 0.)
    extrapolation = step.size() / step.older_distance;
  result.equ(1. + extrapolation, velocity);
  if (extrapolation != 0.)
    result.add(-extrapolation, velocity_older);
}
} // namespace Continua
