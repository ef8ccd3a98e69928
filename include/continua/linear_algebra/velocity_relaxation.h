#ifndef continua_linear_algebra_velocity_relaxation_h
#define continua_linear_algebra_velocity_relaxation_h

#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/// A rough and symmetric inverse of A for the velocities that are not stiff, as a part of a
/// preconditioner. Collective; allocates nothing.
class VelocityRelaxation
{
public:
  virtual ~VelocityRelaxation() = default;
  /// Adds the rough solution for a residual.
  virtual void add_relaxed(DistributedVector &velocity, const DistributedVector &residual) = 0;
  /// residual = source - A velocity. At stiff velocities it may lose digits to cancellation where
  /// the stiff velocities themselves are in it.
  virtual void leave_residual(DistributedVector &residual,
                              const DistributedVector &velocity,
                              const DistributedVector &source) = 0;
};
} // namespace Continua

#endif
