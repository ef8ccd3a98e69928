#ifndef continua_linear_algebra_divergence_operator_h
#define continua_linear_algebra_divergence_operator_h

#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/// The matrix B of the divergence, however its products are formed. Collective.
class DivergenceOperator
{
public:
  virtual ~DivergenceOperator() = default;
  /// target = B source, from velocities to rows of the pressure. Allocates nothing.
  virtual void multiply(DistributedVector &target, const DistributedVector &source) const = 0;
  /// target = B^T source. Allocates nothing.
  virtual void multiply_transposed(DistributedVector &target,
                                   const DistributedVector &source) const = 0;
};
} // namespace Continua

#endif
