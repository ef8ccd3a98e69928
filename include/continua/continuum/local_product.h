#ifndef continua_continuum_local_product_h
#define continua_continuum_local_product_h

#include <continua/linear_algebra/distributed_vector.h>

#include <numeric>

namespace Continua
{
/// This rank's part of a scalar product: numbers are summed over the ranks together, once.
inline double local_product(const DistributedVector &a, const DistributedVector &b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}
} // namespace Continua

#endif
