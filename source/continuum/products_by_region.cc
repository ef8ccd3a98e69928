#include <continua/continuum/products_by_region.h>

#include <deal.II/base/exceptions.h>

namespace Continua
{
void ProductsByRegion::multiply_levels(const unsigned int region,
                                       const DistributedVector &velocity,
                                       const DistributedVector &displacement,
                                       DistributedVector *const mass_of_velocity,
                                       DistributedVector *const stiffness_of_velocity,
                                       DistributedVector *const stiffness_of_displacement) const
{
  if (mass_of_velocity != nullptr)
    multiply_mass(region, *mass_of_velocity, velocity);
  if (stiffness_of_velocity != nullptr)
    multiply_stiffness(region, *stiffness_of_velocity, velocity);
  if (stiffness_of_displacement != nullptr)
    multiply_stiffness(region, *stiffness_of_displacement, displacement);
}

void ProductsByRegion::multiply_support_stiffness(unsigned int,
                                                  DistributedVector &,
                                                  const DistributedVector &) const
{
  AssertThrow(false, dealii::ExcNotImplemented());
}

void ProductsByRegion::multiply_support_damping(unsigned int,
                                                DistributedVector &,
                                                const DistributedVector &) const
{
  AssertThrow(false, dealii::ExcNotImplemented());
}
} // namespace Continua
