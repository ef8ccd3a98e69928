#ifndef continua_continuum_state_levels_h
#define continua_continuum_state_levels_h

#include <continua/linear_algebra/distributed_vector.h>
#include <continua/time_integration/step.h>

namespace Continua
{
/// Velocity [m/s] and pressure [Pa] at the present time and one step before; owned entries.
struct StateLevels
{
  DistributedVector velocity, velocity_older, pressure, pressure_older;

  /// There was no step: what was before is what is present.
  void forget_older();
  /// Sets the velocity at the level that a step balances, as the last step went. `is_of_scheme`:
  /// the distance of the older level counts in a step that extrapolates, too.
  void extrapolate_velocity(const Step &step, bool is_of_scheme, DistributedVector &result) const;
};
} // namespace Continua

#endif
