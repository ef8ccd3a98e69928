#include <continua/analysis/mean_of_loads.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
constexpr std::size_t samples_of_mean = 1024;

/// Whether it has a mean wherever it acts. What depends on place and time is known by its samples
/// alone.
bool has_mean_everywhere(const Waveform &load, const PeriodicStateParameters &beats)
{
  if (load.is_zero() || (load.depends_on_time() && load.depends_on_space()))
    return false;
  if (!load.depends_on_time())
    return true;
  const double origin[3] = {0., 0., 0.};
  double sum = 0., largest = 0.;
  for (std::size_t j = 0; j < samples_of_mean; ++j)
  {
    const double value =
        load(origin, (beats.first_of_loads + (j + 0.5) / samples_of_mean) * beats.period);
    sum += value / samples_of_mean;
    largest = std::max(largest, std::abs(value));
  }
  return std::abs(sum) > no_mean_of_load * largest;
}
} // namespace

bool loads_have_mean(const Problem &problem, const PeriodicStateParameters &beats)
{
  std::vector<Waveform> all = problem.interior.body_force;
  all.insert(all.end(), problem.interior.acceleration.begin(), problem.interior.acceleration.end());
  for (const BoundaryCondition &condition : problem.conditions)
  {
    for (const BoundaryPart *part : {&condition.normal, &condition.tangential})
    {
      all.insert(all.end(), part->vector.begin(), part->vector.end());
      all.push_back(part->along_normal);
    }
    if (condition.free_flow)
      all.push_back(condition.free_flow->rate);
    if (condition.outlet)
      all.push_back(condition.outlet->pressure_behind);
  }
  return std::any_of(all.begin(), all.end(),
                     [&beats](const Waveform &load) { return has_mean_everywhere(load, beats); });
}

bool creeps_for_ever(const Material &material)
{
  return material.is_solid() &&
         (material.has_power_law() || material.long_term_shear_modulus() == 0.);
}

double longest_relaxation(const Problem &problem)
{
  double longest = 0.;
  const auto take = [&longest](const double time)
  {
    if (std::isfinite(time))
      longest = std::max(longest, time);
  };
  for (const Material &material : problem.materials)
  {
    for (const Branch &branch : material.shear.branches)
      take(branch.relaxation_time);
    for (const BulkBranch &branch : material.compression.bulk_branches())
      take(branch.relaxation_time);
  }
  for (const BoundaryCondition &condition : problem.conditions)
    if (condition.outlet)
      for (const Impedance::Term &term : condition.outlet->impedance.terms)
        if (term.rate > 0.)
          take(1. / term.rate);
  return longest;
}
} // namespace Continua
