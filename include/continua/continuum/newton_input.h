#ifndef continua_continuum_newton_input_h
#define continua_continuum_newton_input_h

#include <continua/continuum/system_coefficients.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/time_integration/step.h>

namespace Continua
{
/// What Newton's iteration of a step starts from.
struct NewtonInput
{
  const Step &step;
  const SystemCoefficients &coefficients;
  bool system_is_new;                ///< the coefficients are others than those of the step before
  const DistributedVector &momentum; ///< f of the linear equations [N]
  const DistributedVector &mass;     ///< g of them [m^3/s]
  const DistributedVector &predicted_pressure; ///< p_plus [Pa]
  const DistributedVector &velocity_old;       ///< at the step's start [m/s]
  /// D_plus of the displacement with Deformation::finite, else unused [m].
  const DistributedVector &predicted_displacement;
};
} // namespace Continua

#endif
