#include <continua/continuum/linear_system.h>

namespace Continua
{
void LinearSystem::set_reaction(const DistributedVector &profile,
                                DistributedVector &of_velocity,
                                DistributedVector &of_pressure,
                                DistributedVector &momentum,
                                DistributedVector &mass)
{
  of_velocity = 0.;
  add_velocity_product(profile, of_velocity);
  of_pressure = 0.;
  add_divergence(profile, of_pressure);
  momentum = 0.;
  mass = 0.;
  eliminate_prescribed(profile, momentum, mass);
}
} // namespace Continua
