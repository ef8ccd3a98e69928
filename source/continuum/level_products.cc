#include <continua/continuum/level_products.h>

#include <continua/linear_algebra/linear_combination.h>

#include <limits>

namespace Continua
{
LevelProducts::LevelProducts(const Problem &problem,
                             Operators &operators,
                             const BranchHistory &history,
                             const DistributedVector &velocity,
                             const DistributedVector &velocity_older)
    : problem(problem),
      operators(operators),
      history(history),
      velocity(velocity),
      velocity_older(velocity_older),
      regions(problem.materials.size())
{
}

void LevelProducts::reinit()
{
  // The vectors are made where they are needed.
  regions.assign(problem.materials.size(), Region());
  for (unsigned int region = 0; region < regions.size(); ++region)
  {
    std::array<bool, n_kinds> &wants = regions[region].wants;
    wants[mass_of_velocity] = true;
    wants[stiffness_of_velocity] = problem.materials[region].shear.viscosity != 0.;
    wants[stiffness_of_displacement] = history.is_elastic(region);
  }
  knows_step = false;
}

void LevelProducts::forget()
{
  for (Region &region : regions)
  {
    region.present.is_known = {};
    region.older.is_known = {};
    region.divergence_is_known = false;
  }
  knows_step = false;
}

void LevelProducts::forget_older()
{
  for (Region &region : regions)
    region.older.is_known = {};
}

void LevelProducts::advance()
{
  for (Region &region : regions)
  {
    for (unsigned int kind = 0; kind < n_kinds; ++kind)
    {
      region.older.products[kind].swap(region.present.products[kind]);
      region.older.is_known[kind] = region.present.is_known[kind];
      region.present.is_known[kind] = false;
    }
    region.divergence_is_known = false;
  }
  knows_step = true;
}

bool LevelProducts::has(const unsigned int region) const
{
  return !is_shared && operators.products().has_level_products() &&
         !(operators.has_all_terms_in(region));
}

const DistributedVector &
LevelProducts::product(const unsigned int number, const Kind kind, const bool of_older)
{
  Region &region = regions[number];
  Level &level = of_older ? region.older : region.present;
  if (level.is_known[kind])
    return level.products[kind];
  region.wants[kind] = true;
  std::array<DistributedVector *, n_kinds> targets = {};
  for (unsigned int other = 0; other < n_kinds; ++other)
    if (region.wants[other] && !level.is_known[other])
    {
      targets[other] = &level.products[other];
      if (level.products[other].size() == 0)
        level.products[other].reinit(velocity);
      level.is_known[other] = true;
    }
  operators.products().multiply_levels(
      number, of_older ? velocity_older : velocity,
      of_older ? history.displacement_older() : history.displacement(), targets[mass_of_velocity],
      targets[stiffness_of_velocity], targets[stiffness_of_displacement]);
  return level.products[kind];
}

const DistributedVector &LevelProducts::mass(const unsigned int region)
{
  return product(region, mass_of_velocity, false);
}

const DistributedVector &LevelProducts::stiffness(const unsigned int region)
{
  return product(region, stiffness_of_displacement, false);
}

const DistributedVector &LevelProducts::divergence(const unsigned int number)
{
  Region &region = regions[number];
  region.wants_divergence = true;
  if (region.divergence_is_known)
    return region.divergence;
  if (region.divergence.size() == 0)
    region.divergence = operators.pressure_vector();
  operators.products().multiply_divergence(number, region.divergence, velocity);
  region.divergence_is_known = true;
  return region.divergence;
}

const DistributedVector &LevelProducts::past_inertia(const unsigned int number, const Step &step)
{
  DistributedVector &past = regions[number].past_inertia;
  if (past.size() == 0)
    past.reinit(velocity);
  const DistributedVector &present = mass(number);
  if (step.a2 != 0.)
    set_combination(past, -step.a1, present, -step.a2, product(number, mass_of_velocity, true));
  else
    past.equ(-step.a1, present);
  return past;
}

void LevelProducts::add_past_stress(const unsigned int region,
                                    const Step &step,
                                    DistributedVector &momentum)
{
  const double modulus = spring(region);
  const BranchCoefficients c = step.branch(std::numeric_limits<double>::infinity());
  momentum.add(-modulus * c.old, stiffness(region));
  if (c.older != 0.)
    momentum.add(-modulus * c.older, product(region, stiffness_of_displacement, true));
  if (c.velocity_old != 0.)
    momentum.add(-modulus * c.velocity_old, product(region, stiffness_of_velocity, false));
}

void LevelProducts::set_inertia(const unsigned int region,
                                const Step &step,
                                DistributedVector &target)
{
  set_balanced(region, mass_of_velocity, step, target);
  set_combination(target, step.a0, target, -1., regions[region].past_inertia);
}

void LevelProducts::set_stiffness_of_velocity(const unsigned int region,
                                              const Step &step,
                                              DistributedVector &target)
{
  set_balanced(region, stiffness_of_velocity, step, target);
}

void LevelProducts::set_stiffness(const unsigned int region,
                                  const Step &step,
                                  DistributedVector &target)
{
  set_balanced(region, stiffness_of_displacement, step, target);
}

void LevelProducts::set_balanced(const unsigned int region,
                                 const Kind kind,
                                 const Step &step,
                                 DistributedVector &target)
{
  if (step.extrapolate)
    set_combination(target, 0.5, product(region, kind, false), 0.5, product(region, kind, true));
  else
    target.equ(1., product(region, kind, false));
}
} // namespace Continua
