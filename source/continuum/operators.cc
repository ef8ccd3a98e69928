#include <continua/continuum/operators.h>

namespace Continua
{
void Operators::multiply_levels(const unsigned int region,
                                const DistributedVector &velocity,
                                const DistributedVector &displacement,
                                DistributedVector *const mass_of_velocity,
                                DistributedVector *const stiffness_of_velocity,
                                DistributedVector *const stiffness_of_displacement)
{
  if (mass_of_velocity != nullptr)
    multiply_mass(region, *mass_of_velocity, velocity);
  if (stiffness_of_velocity != nullptr)
    multiply_stiffness(region, *stiffness_of_velocity, velocity);
  if (stiffness_of_displacement != nullptr)
    multiply_stiffness(region, *stiffness_of_displacement, displacement);
}

void Operators::multiply_support_stiffness(unsigned int,
                                           DistributedVector &,
                                           const DistributedVector &)
{
  AssertThrow(false, dealii::ExcNotImplemented());
}

void Operators::multiply_support_damping(unsigned int,
                                         DistributedVector &,
                                         const DistributedVector &)
{
  AssertThrow(false, dealii::ExcNotImplemented());
}

DistributedVector Operators::flow_of_velocities(unsigned int) const
{
  AssertThrow(false, dealii::ExcNotImplemented());
  return {};
}

DistributedVector Operators::flow_profile(unsigned int) const
{
  AssertThrow(false, dealii::ExcNotImplemented());
  return {};
}

std::vector<double> Operators::cavity_volumes(const DistributedVector &)
{
  AssertThrow(false, dealii::ExcNotImplemented());
  return {};
}

void Operators::linearise_cavity(unsigned int,
                                 const DistributedVector &,
                                 DistributedVector &,
                                 DistributedVector &)
{
  AssertThrow(false, dealii::ExcNotImplemented());
}

void Operators::add_velocity_product(const DistributedVector &, DistributedVector &)
{
  AssertThrow(false, dealii::ExcNotImplemented());
}

void Operators::add_divergence(const DistributedVector &, DistributedVector &)
{
  AssertThrow(false, dealii::ExcNotImplemented());
}

void Operators::set_reaction(const DistributedVector &profile,
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
