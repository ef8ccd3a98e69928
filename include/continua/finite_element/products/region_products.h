#ifndef continua_finite_element_products_region_products_h
#define continua_finite_element_products_region_products_h

#include <continua/linear_algebra/distributed_vector.h>

#include <vector>

namespace Continua
{
/// Products with the mass and the stiffness of single regions, which have no matrix. The hanging
/// nodes are condensed, and no boundary constraints are in them. Collective.
class RegionProducts
{
public:
  virtual ~RegionProducts() = default;
  /// target = (mass M + stiffness S) source.
  virtual void multiply(unsigned int region,
                        double mass,
                        double stiffness,
                        DistributedVector &target,
                        const DistributedVector &source) const = 0;
  virtual void mass_diagonal(unsigned int region, DistributedVector &diagonal) const = 0;
  virtual void stiffness_diagonal(unsigned int region, DistributedVector &diagonal) const = 0;
  /// Local indices of the owned velocities that are in a product of the region, in their order.
  virtual const std::vector<unsigned int> &nodes(unsigned int region) const = 0;
};
} // namespace Continua

#endif
