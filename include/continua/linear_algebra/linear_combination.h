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
  double *const to = target.begin();
  const double *const of_x = x.begin();
  const double *const of_y = y.begin();
  const unsigned int n = target.locally_owned_size();
  for (unsigned int i = 0; i < n; ++i)
    to[i] = a * of_x[i] + b * of_y[i];
}
} // namespace Continua

#endif
