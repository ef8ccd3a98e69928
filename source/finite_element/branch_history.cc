#include <continua/finite_element/branch_history.h>
#include <continua/finite_element/vector_archive.h>

#include <deal.II/base/exceptions.h>

#include <limits>

namespace Continua
{
BranchHistory::BranchHistory(const std::vector<Material> &materials)
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
void BranchHistory::reinit(const Space<dim> &space)
{
  for (Branch &branch : branches)
  {
    branch.present = space.velocity_vector();
    branch.older = branch.present;
    branch.balanced = branch.present;
  }
}

const BranchHistory::Branch &BranchHistory::find(const double relaxation_time) const
{
  for (const Branch &branch : branches)
    if (branch.relaxation_time == relaxation_time)
      return branch;
  AssertThrow(false, dealii::ExcInternalError());
  return branches.front();
}

void BranchHistory::predict(const Step &step, const DistributedVector &velocity_old)
{
  for (Branch &branch : branches)
  {
    const BranchCoefficients coefficients = step.branch(branch.relaxation_time);
    branch.balanced.equ(coefficients.old, branch.present);
    if (coefficients.older != 0.)
      branch.balanced.add(coefficients.older, branch.older);
    if (coefficients.velocity_old != 0.)
      branch.balanced.add(coefficients.velocity_old, velocity_old);
  }
}

void BranchHistory::correct(const Step &step, const DistributedVector &velocity)
{
  for (Branch &branch : branches)
    branch.balanced.add(step.branch(branch.relaxation_time).velocity, velocity);
}

void BranchHistory::finish(const Step &step)
{
  for (Branch &branch : branches)
  {
    branch.older.swap(branch.present);
    if (step.extrapolate)
    {
      branch.present.equ(2., branch.balanced);
      branch.present.add(-1., branch.older);
    }
    else
      branch.present.equ(1., branch.balanced);
  }
}

template <typename Select>
bool BranchHistory::mix_vectors(const Material &material,
                                DistributedVector &mixture,
                                const Select &select) const
{
  bool first = true;
  for (const Continua::Branch &branch : material.branches)
  {
    const DistributedVector &vector = select(find(branch.relaxation_time));
    if (first)
      mixture.equ(branch.shear_modulus, vector);
    else
      mixture.add(branch.shear_modulus, vector);
    first = false;
  }
  return !first;
}

bool BranchHistory::mix_balanced(const Material &material, DistributedVector &mixture) const
{
  return mix_vectors(material, mixture,
                     [](const Branch &b) -> const DistributedVector & { return b.balanced; });
}

bool BranchHistory::mix(const Material &material, DistributedVector &mixture) const
{
  return mix_vectors(material, mixture,
                     [](const Branch &b) -> const DistributedVector & { return b.present; });
}

double BranchHistory::step_stiffness(const Material &material, const Step &step) const
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

template void BranchHistory::reinit(const Space<2> &);
template void BranchHistory::reinit(const Space<3> &);
} // namespace Continua
