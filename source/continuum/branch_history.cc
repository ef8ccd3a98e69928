#include <continua/continuum/branch_history.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Continua
{
namespace
{
void add(std::vector<double> &sum, const double factor, const std::vector<double> &values)
{
  double *const to = sum.data();
  const double *const from = values.data();
  for (std::size_t j = 0; j < sum.size(); ++j)
    to[j] += factor * from[j];
}

void gather(std::vector<double> &values,
            const std::vector<unsigned int> &nodes,
            const DistributedVector &vector)
{
  values.resize(nodes.size());
  const double *const entries = vector.begin();
  for (std::size_t j = 0; j < nodes.size(); ++j)
    values[j] = entries[nodes[j]];
}

void scatter(const std::vector<double> &values,
             const std::vector<unsigned int> &nodes,
             DistributedVector &vector)
{
  double *const entries = vector.begin();
  for (std::size_t j = 0; j < nodes.size(); ++j)
    entries[nodes[j]] = values[j];
}

/// Weights of D at the present time and one step before.
struct Weights
{
  double present, older;
};

/// Carries one branch to the end of the step, at n places; `next` holds what is two steps old.
void advance_entries(const BranchCoefficients &c,
                     const bool extrapolate,
                     const std::size_t n,
                     const double *const start,
                     const double *const at_level,
                     const double *const present,
                     double *const next)
{
  // Of the end of the step: twice the balanced level less the start, or that level.
  const double scale = extrapolate ? 2. : 1.;
  const double of_balanced = scale * c.velocity, of_start = scale * c.velocity_old,
               of_present = scale * c.old - (extrapolate ? 1. : 0.), of_older = scale * c.older;
  if (of_start == 0. && of_older == 0.)
    for (std::size_t i = 0; i < n; ++i)
      next[i] = of_balanced * at_level[i] + of_present * present[i];
  else
    for (std::size_t i = 0; i < n; ++i)
      next[i] = of_balanced * at_level[i] + of_present * present[i] + of_older * next[i] +
                of_start * start[i];
}
} // namespace

BranchHistory::BranchHistory(const std::vector<Material> &materials, const Deformation deformation)
    : materials(materials)
{
  branches.push_back({std::numeric_limits<double>::infinity(), {}, {}});
  for (const Material &material : materials)
  {
    Region region;
    for (const Continua::Branch &branch : material.shear.branches)
    {
      if (std::isinf(branch.relaxation_time))
      {
        region.spring += branch.shear_modulus;
        continue;
      }
      if (deformation == Deformation::finite)
        continue;
      unsigned int number = 0;
      while (number < branches.size() && branches[number].relaxation_time != branch.relaxation_time)
        ++number;
      if (number == branches.size())
        branches.push_back({branch.relaxation_time, {}, {}});
      region.branches.push_back({number, branch.shear_modulus, branch.relaxation_time, {}, {}});
    }
    regions.push_back(region);
  }
}

void BranchHistory::reinit(const DistributedVector &prototype,
                           const std::vector<std::vector<unsigned int>> &nodes_of_regions)
{
  AssertDimension(nodes_of_regions.size(), regions.size());
  for (unsigned int number = 0; number < regions.size(); ++number)
  {
    Region &region = regions[number];
    region.nodes = nodes_of_regions[number];
    region.sum.assign(region.nodes.size(), 0.);
    for (NodalBranch &branch : region.branches)
    {
      branch.present.assign(region.nodes.size(), 0.);
      branch.older.assign(region.nodes.size(), 0.);
    }
  }
  for (Branch &branch : branches)
  {
    branch.present.reinit(prototype);
    branch.older.reinit(prototype);
  }
  vectors_are_current = nodes_are_current = true;
}

unsigned int BranchHistory::find(const double relaxation_time) const
{
  for (unsigned int number = 0; number < branches.size(); ++number)
    if (branches[number].relaxation_time == relaxation_time)
      return number;
  AssertThrow(false, dealii::ExcInternalError());
  return 0;
}

void BranchHistory::update_vectors() const
{
  if (vectors_are_current)
    return;
  for (const Region &region : regions)
    for (const NodalBranch &branch : region.branches)
    {
      scatter(branch.present, region.nodes, branches[branch.branch].present);
      scatter(branch.older, region.nodes, branches[branch.branch].older);
    }
  vectors_are_current = true;
}

void BranchHistory::update_nodes() const
{
  if (nodes_are_current)
    return;
  for (Region &region : regions)
    for (NodalBranch &branch : region.branches)
    {
      gather(branch.present, region.nodes, branches[branch.branch].present);
      gather(branch.older, region.nodes, branches[branch.branch].older);
    }
  nodes_are_current = true;
}

template <typename WeightsOf>
bool BranchHistory::mix_values(const unsigned int number,
                               DistributedVector &mixture,
                               const WeightsOf &weights_of) const
{
  if (materials[number].shear.branches.empty())
    return false;
  update_nodes();
  Region &region = regions[number];
  std::fill(region.sum.begin(), region.sum.end(), 0.);
  for (const NodalBranch &branch : region.branches)
  {
    const Weights weights = weights_of(branch.relaxation_time);
    add(region.sum, branch.shear_modulus * weights.present, branch.present);
    if (weights.older != 0.)
      add(region.sum, branch.shear_modulus * weights.older, branch.older);
  }
  const Weights weights = weights_of(branches[0].relaxation_time);
  const double of_present = region.spring * weights.present,
               of_older = region.spring * weights.older;
  const double *const present = branches[0].present.begin();
  const double *const older = branches[0].older.begin();
  double *const entries = mixture.begin();
  for (std::size_t j = 0; j < region.nodes.size(); ++j)
  {
    const unsigned int i = region.nodes[j];
    entries[i] = region.sum[j] + of_present * present[i] + of_older * older[i];
  }
  return true;
}

bool BranchHistory::predict(const unsigned int region,
                            const Step &step,
                            const DistributedVector &velocity_old,
                            DistributedVector &mixture) const
{
  const auto weights_of = [&step](const double relaxation_time)
  {
    const BranchCoefficients c = step.branch(relaxation_time);
    return Weights{c.old, c.older};
  };
  if (!mix_values(region, mixture, weights_of))
    return false;
  double of_velocity = 0.;
  for (const Continua::Branch &branch : materials[region].shear.branches)
    of_velocity += branch.shear_modulus * step.branch(branch.relaxation_time).velocity_old;
  if (of_velocity != 0.)
    for (const unsigned int i : regions[region].nodes)
      mixture.begin()[i] += of_velocity * velocity_old.begin()[i];
  return true;
}

void BranchHistory::predict_displacement(const Step &step,
                                         const DistributedVector &velocity_old,
                                         DistributedVector &displacement) const
{
  const BranchCoefficients c = step.branch(branches[0].relaxation_time);
  displacement.equ(c.old, branches[0].present);
  if (c.older != 0.)
    displacement.add(c.older, branches[0].older);
  if (c.velocity_old != 0.)
    displacement.add(c.velocity_old, velocity_old);
}

void BranchHistory::advance(const Step &step,
                            const DistributedVector &velocity_old,
                            const DistributedVector &velocity)
{
  update_nodes();
  Branch &displacement = branches[0];
  advance_entries(step.branch(displacement.relaxation_time), step.extrapolate,
                  displacement.present.locally_owned_size(), velocity_old.begin(), velocity.begin(),
                  displacement.present.begin(), displacement.older.begin());
  displacement.present.swap(displacement.older);
  for (Region &region : regions)
  {
    if (region.branches.empty())
      continue;
    vectors_are_current = false;
    gather(start_at_nodes, region.nodes, velocity_old);
    gather(balanced_at_nodes, region.nodes, velocity);
    for (NodalBranch &branch : region.branches)
    {
      advance_entries(step.branch(branch.relaxation_time), step.extrapolate, region.nodes.size(),
                      start_at_nodes.data(), balanced_at_nodes.data(), branch.present.data(),
                      branch.older.data());
      branch.present.swap(branch.older);
    }
  }
}

bool BranchHistory::mix_balanced(const unsigned int region,
                                 const Step &step,
                                 DistributedVector &mixture) const
{
  if (!step.extrapolate)
    return mix(region, mixture);
  return mix_values(region, mixture, [](double) { return Weights{0.5, 0.5}; });
}

bool BranchHistory::mix(const unsigned int region, DistributedVector &mixture) const
{
  return mix_values(region, mixture, [](double) { return Weights{1., 0.}; });
}

template <typename Value>
void BranchHistory::set_at_nodes(const double relaxation_time,
                                 DistributedVector &vector,
                                 const Value &value) const
{
  update_nodes();
  const unsigned int number = find(relaxation_time);
  for (const Region &region : regions)
    for (const NodalBranch &branch : region.branches)
      if (branch.branch == number)
        for (std::size_t j = 0; j < region.nodes.size(); ++j)
        {
          const unsigned int i = region.nodes[j];
          vector.begin()[i] = value(branch.present[j], branch.older[j], i);
        }
}

void BranchHistory::balanced_displacement(const double relaxation_time,
                                          const Step &step,
                                          DistributedVector &displacement) const
{
  const bool middle = step.extrapolate;
  if (std::isinf(relaxation_time))
  {
    displacement.equ(middle ? 0.5 : 1., branches[0].present);
    if (middle)
      displacement.add(0.5, branches[0].older);
    return;
  }
  set_at_nodes(relaxation_time, displacement,
               [middle](const double present, const double older, unsigned int)
               { return middle ? 0.5 * (present + older) : present; });
}

void BranchHistory::forgotten_velocity(const double relaxation_time,
                                       const Step &step,
                                       const DistributedVector &velocity,
                                       DistributedVector &forgotten) const
{
  const bool middle = step.extrapolate;
  if (!step.branch_is_exponential(relaxation_time))
  {
    set_at_nodes(relaxation_time, forgotten,
                 [middle, relaxation_time](const double present, const double older, unsigned int)
                 { return (middle ? 0.5 * (present + older) : present) / relaxation_time; });
    return;
  }
  // The exponential update obeys the equation over the step as a whole.
  const double *const at_level = velocity.begin();
  const double size = step.time - step.time_old;
  set_at_nodes(relaxation_time, forgotten,
               [at_level, size](const double present, const double older, const unsigned int i)
               { return at_level[i] - (present - older) / size; });
}

double BranchHistory::step_stiffness(const Material &material, const Step &step)
{
  double sum = 0.;
  for (const Continua::Branch &branch : material.shear.branches)
    sum += branch.shear_modulus * step.branch(branch.relaxation_time).velocity;
  return sum;
}

double BranchHistory::step_displacement(const Step &step)
{
  return step.branch(std::numeric_limits<double>::infinity()).velocity;
}

const DistributedVector &BranchHistory::internal_displacement(const double relaxation_time) const
{
  update_vectors();
  return branches[find(relaxation_time)].present;
}

std::vector<double> BranchHistory::exponential_branches(const Step &step) const
{
  std::vector<double> times;
  for (const Branch &branch : branches)
    if (step.branch_is_exponential(branch.relaxation_time))
      times.push_back(branch.relaxation_time);
  return times;
}

void BranchHistory::visit(StateVisitor &visitor)
{
  if (visitor.takes_vectors())
  {
    update_vectors();
    nodes_are_current = false;
    for (unsigned int k = 0; k < branches.size(); ++k)
      visitor.levels({"branch", k}, StateKind::velocity, branches[k].present, branches[k].older);
    return;
  }
  update_nodes();
  visitor.levels({"branch", 0}, StateKind::velocity, branches[0].present, branches[0].older);
  for (Region &region : regions)
    for (NodalBranch &branch : region.branches)
    {
      visitor.levels({"branch", branch.branch}, branch.present.data(), branch.older.data(),
                     branch.present.size());
      vectors_are_current = false;
    }
}
} // namespace Continua
