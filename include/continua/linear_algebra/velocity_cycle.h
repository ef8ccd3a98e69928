#ifndef continua_linear_algebra_velocity_cycle_h
#define continua_linear_algebra_velocity_cycle_h

#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/// A factor, or one cycle of a multigrid method, for some of the velocities: a symmetric inverse of
/// their part of A, or of A with an augmentation, or nearly one. Collective.
class VelocityCycle
{
public:
  virtual ~VelocityCycle() = default;
  /// Adds what one cycle finds for its part of the source. Other entries stay as they are.
  virtual void add_cycle(DistributedVector &target, const DistributedVector &source) = 0;
};
} // namespace Continua

#endif
