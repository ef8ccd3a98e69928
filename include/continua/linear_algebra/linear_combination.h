#ifndef continua_linear_algebra_linear_combination_h
#define continua_linear_algebra_linear_combination_h

#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/// target = a x + b y on the owned entries, in one pass; x or y may be the target.
inline void set_combination(DistributedVector &target,
                            const double a,
                            const DistributedVector &x,
                            const double b,
                            const DistributedVector &y)
{
  Assert(have_same_layout(target, x) && have_same_layout(target, y), dealii::ExcInternalError());
  // deal.II's vector would need two passes.
  target.trilinos_vector().Update(a, x.trilinos_vector(), b, y.trilinos_vector(), 0.);
}
} // namespace Continua

#endif
