#include <continua/finite_element/branch_history.h>
#include <continua/finite_element/vector_archive.h>

#include <deal.II/base/exceptions.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

namespace Continua
{
BranchHistory::BranchHistory(const std::vector<Material> &materials) : materials(materials)
{
  branches.push_back({std::numeric_limits<double>::infinity(), {}, {}, {}});
  for (const Material &material : materials)
    for (const Continua::Branch &branch : material.branches)
    {
      bool known = false;
      for (const Branch &other : branches)
        known = known || other.relaxation_time == branch.relaxation_time;
      if (!known)
        branches.push_back({branch.relaxation_time, {}, {}, {}});
    }
}

template <int dim>
void BranchHistory::reinit(const Space<dim> &space, const std::vector<RegionOperators> &operators)
{
  const unsigned int n_dofs = space.velocity_owned.n_elements();
  nodes_of_region.assign(operators.size(), {});
  for (unsigned int region = 0; region < operators.size(); ++region)
    for (unsigned int i = 0; i < n_dofs; ++i)
      if (operators[region].stiffness.trilinos_matrix().NumMyEntries(i) > 0)
        nodes_of_region[region].push_back(i);
  for (Branch &branch : branches)
  {
    branch.present = space.velocity_vector();
    branch.older = branch.present;
    branch.nodes.clear();
    for (unsigned int region = 0; region < operators.size(); ++region)
      for (const Continua::Branch &of_material : materials[region].branches)
        if (of_material.relaxation_time == branch.relaxation_time)
        {
          std::vector<unsigned int> both;
          std::set_union(branch.nodes.begin(), branch.nodes.end(), nodes_of_region[region].begin(),
                         nodes_of_region[region].end(), std::back_inserter(both));
          branch.nodes.swap(both);
          break;
        }
  }
  // The displacement is that of the whole body.
  branches[0].nodes.resize(n_dofs);
  std::iota(branches[0].nodes.begin(), branches[0].nodes.end(), 0);
}

const BranchHistory::Branch &BranchHistory::find(const double relaxation_time) const
{
  for (const Branch &branch : branches)
    if (branch.relaxation_time == relaxation_time)
      return branch;
  AssertThrow(false, dealii::ExcInternalError());
  return branches.front();
}

template <typename Value>
bool BranchHistory::mix_values(const unsigned int region,
                               DistributedVector &mixture,
                               const Value &value) const
{
  const std::vector<Continua::Branch> &of_region = materials[region].branches;
  double *const entries = mixture.begin();
  for (std::size_t k = 0; k < of_region.size(); ++k)
  {
    const Branch &branch = find(of_region[k].relaxation_time);
    const double modulus = of_region[k].shear_modulus;
    const auto of_branch = value(branch);
    if (k == 0)
      for (const unsigned int i : nodes_of_region[region])
        entries[i] = modulus * of_branch(i);
    else
      for (const unsigned int i : nodes_of_region[region])
        entries[i] += modulus * of_branch(i);
  }
  return !of_region.empty();
}

bool BranchHistory::predict(const unsigned int region,
                            const Step &step,
                            const DistributedVector &velocity_old,
                            DistributedVector &mixture) const
{
  const double *const velocity = velocity_old.begin();
  return mix_values(region, mixture,
                    [&step, velocity](const Branch &branch)
                    {
                      const BranchCoefficients c = step.branch(branch.relaxation_time);
                      const double *const present = branch.present.begin();
                      const double *const older = branch.older.begin();
                      return [c, present, older, velocity](const unsigned int i) {
                        return c.old * present[i] + c.older * older[i] +
                               c.velocity_old * velocity[i];
                      };
                    });
}

void BranchHistory::advance(const Step &step,
                            const DistributedVector &velocity_old,
                            const DistributedVector &velocity)
{
  const double *const start = velocity_old.begin();
  const double *const balanced = velocity.begin();
  for (Branch &branch : branches)
  {
    const BranchCoefficients c = step.branch(branch.relaxation_time);
    const double *const present = branch.present.begin();
    double *const next = branch.older.begin(); // takes the place of what is two steps old then
    for (const unsigned int i : branch.nodes)
    {
      const double at_level = c.velocity * balanced[i] + c.old * present[i] + c.older * next[i] +
                              c.velocity_old * start[i];
      next[i] = step.extrapolate ? 2. * at_level - present[i] : at_level;
    }
    branch.present.swap(branch.older);
  }
}

bool BranchHistory::mix_balanced(const unsigned int region,
                                 const Step &step,
                                 DistributedVector &mixture) const
{
  if (!step.extrapolate)
    return mix(region, mixture);
  return mix_values(region, mixture,
                    [](const Branch &branch)
                    {
                      const double *const present = branch.present.begin();
                      const double *const older = branch.older.begin();
                      return [present, older](const unsigned int i)
                      { return 0.5 * (present[i] + older[i]); };
                    });
}

bool BranchHistory::mix(const unsigned int region, DistributedVector &mixture) const
{
  return mix_values(region, mixture,
                    [](const Branch &branch)
                    {
                      const double *const present = branch.present.begin();
                      return [present](const unsigned int i) { return present[i]; };
                    });
}

void BranchHistory::balanced_displacement(const double relaxation_time,
                                          const Step &step,
                                          DistributedVector &displacement) const
{
  const Branch &branch = find(relaxation_time);
  for (const unsigned int i : branch.nodes)
    displacement.begin()[i] = step.extrapolate
                                  ? 0.5 * (branch.present.begin()[i] + branch.older.begin()[i])
                                  : branch.present.begin()[i];
}

void BranchHistory::forgotten_velocity(const double relaxation_time,
                                       const Step &step,
                                       const DistributedVector &velocity,
                                       DistributedVector &forgotten) const
{
  const Branch &branch = find(relaxation_time);
  if (!step.branch_is_exponential(relaxation_time))
  {
    balanced_displacement(relaxation_time, step, forgotten);
    for (const unsigned int i : branch.nodes)
      forgotten.begin()[i] /= relaxation_time;
    return;
  }
  // The exponential update obeys the equation over the step as a whole.
  for (const unsigned int i : branch.nodes)
    forgotten.begin()[i] =
        velocity.begin()[i] -
        (branch.present.begin()[i] - branch.older.begin()[i]) / (step.time - step.time_old);
}

double BranchHistory::step_stiffness(const Material &material, const Step &step)
{
  double sum = 0.;
  for (const Continua::Branch &branch : material.branches)
    sum += branch.shear_modulus * step.branch(branch.relaxation_time).velocity;
  return sum;
}

const DistributedVector &BranchHistory::internal_displacement(const double relaxation_time) const
{
  return find(relaxation_time).present;
}

std::vector<double> BranchHistory::exponential_branches(const Step &step) const
{
  std::vector<double> times;
  for (const Branch &branch : branches)
    if (step.branch_is_exponential(branch.relaxation_time))
      times.push_back(branch.relaxation_time);
  return times;
}

std::vector<DistributedVector *> BranchHistory::vectors()
{
  std::vector<DistributedVector *> all;
  for (Branch &branch : branches)
  {
    all.push_back(&branch.present);
    all.push_back(&branch.older);
  }
  return all;
}

void BranchHistory::save(ArchiveWriter &archive) const
{
  for (unsigned int k = 0; k < branches.size(); ++k)
  {
    save_vector(archive, "branch " + std::to_string(k), branches[k].present);
    save_vector(archive, "branch " + std::to_string(k) + " older", branches[k].older);
  }
}

void BranchHistory::load(const ArchiveReader &archive)
{
  for (unsigned int k = 0; k < branches.size(); ++k)
  {
    load_vector(archive, "branch " + std::to_string(k), branches[k].present);
    load_vector(archive, "branch " + std::to_string(k) + " older", branches[k].older);
  }
}

template void BranchHistory::reinit(const Space<2> &, const std::vector<RegionOperators> &);
template void BranchHistory::reinit(const Space<3> &, const std::vector<RegionOperators> &);
} // namespace Continua
