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
};
} // namespace Continua

#endif
