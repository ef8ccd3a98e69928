#ifndef continua_continuum_harmonic_state_h
#define continua_continuum_harmonic_state_h

#include <continua/linear_algebra/distributed_vector.h>

#include <vector>

namespace Continua
{
/// What a harmonic motion sets of the solver's state; owned entries.
struct HarmonicState
{
  DistributedVector &velocity, &displacement, &pressure; ///< [m/s], [m], [Pa]
  /// The vectors w of the regions, whose deviatoric stress is 2 dev sym grad w; see set_mixture()
  /// [Pa m].
  std::vector<DistributedVector> &mixtures;
  /// Of a state at rest, about which the motion is: the loads are those of this time [s].
  double time_of_loads = 0.;
};
} // namespace Continua

#endif
