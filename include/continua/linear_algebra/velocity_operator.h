#ifndef continua_linear_algebra_velocity_operator_h
#define continua_linear_algebra_velocity_operator_h

#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/// The matrix A of the velocities, however its products are formed. Collective.
class VelocityOperator
{
public:
  virtual ~VelocityOperator() = default;
  /// target = A source. Allocates nothing.
  virtual void multiply(DistributedVector &target, const DistributedVector &source) const = 0;
  /// Of A, positive.
  virtual const DistributedVector &diagonal() const = 0;
};
} // namespace Continua

#endif
