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
  /// By region: of whose gradient its stress is made, see State::mixtures [Pa m].
  std::vector<DistributedVector> &mixtures;
};
} // namespace Continua

#endif
