#include <continua/continuum/bulk_history.h>

#include <deal.II/base/exceptions.h>

namespace Continua
{
BulkHistory::BulkHistory(const std::vector<Material> &materials)
    : materials(materials), of_region(materials.size())
{
}

void BulkHistory::reinit(const DistributedVector &prototype,
                         const std::vector<std::vector<unsigned int>> &nodes_of_regions)
{
  AssertDimension(nodes_of_regions.size(), of_region.size());
  for (unsigned int r = 0; r < of_region.size(); ++r)
    if (has(r))
    {
      Region &region = of_region[r];
      region.nodes = nodes_of_regions[r];
      region.rate.reinit(prototype);
      region.balanced_rate.reinit(prototype);
      // Cleared first: an assignment to the old ones would keep their layout.
      region.dilatations.clear();
      region.dilatations.assign(materials[r].compression.bulk_branches().size(),
                                {region.rate, region.rate});
    }
}

void BulkHistory::start(const DistributedVector &pressure)
{
  for (unsigned int r = 0; r < of_region.size(); ++r)
    for (Dilatation &dilatation : of_region[r].dilatations)
      for (const unsigned int i : of_region[r].nodes)
        dilatation.present.begin()[i] = dilatation.older.begin()[i] =
            -materials[r].inverse_bulk_modulus() * pressure.begin()[i];
}

void BulkHistory::jump(const DistributedVector &pressure_change)
{
  for (unsigned int r = 0; r < of_region.size(); ++r)
    for (Dilatation &dilatation : of_region[r].dilatations)
      for (const unsigned int i : of_region[r].nodes)
      {
        const double change = -materials[r].inverse_bulk_modulus() * pressure_change.begin()[i];
        dilatation.present.begin()[i] += change;
        dilatation.older.begin()[i] += change;
      }
}

double BulkHistory::step_modulus(const Material &material, const Step &step)
{
  double sum = 0.;
  for (const BulkBranch &branch : material.compression.bulk_branches())
    sum += branch.bulk_modulus * step.branch(branch.relaxation_time).velocity;
  return sum;
}

double BulkHistory::step_compressibility(const Material &material, const Step &step)
{
  return material.compression.bulk_branches().empty()
             ? material.inverse_bulk_modulus() / step.pressure_time
             : 1. / step_modulus(material, step);
}

void BulkHistory::predict(const unsigned int r, const Step &step, DistributedVector &pressure) const
{
  const Region &region = of_region[r];
  double *const entries = pressure.begin();
  for (const unsigned int i : region.nodes)
    entries[i] = 0.;
  for (unsigned int k = 0; k < region.dilatations.size(); ++k)
  {
    const BulkBranch &branch = materials[r].compression.bulk_branches()[k];
    const BranchCoefficients c = step.branch(branch.relaxation_time);
    const double *const present = region.dilatations[k].present.begin();
    const double *const older = region.dilatations[k].older.begin();
    const double *const rate = region.rate.begin();
    for (const unsigned int i : region.nodes)
      entries[i] -= branch.bulk_modulus *
                    (c.old * present[i] + c.older * older[i] + c.velocity_old * rate[i]);
  }
}

void BulkHistory::advance(const Step &step, const DistributedVector &pressure)
{
  for (unsigned int r = 0; r < of_region.size(); ++r)
    if (has(r))
    {
      Region &region = of_region[r];
      double *const level_rate = region.balanced_rate.begin();
      double *const rate = region.rate.begin();
      predict(r, step, region.balanced_rate);
      const double inverse_modulus = 1. / step_modulus(materials[r], step);
      for (const unsigned int i : region.nodes)
        level_rate[i] = inverse_modulus * (level_rate[i] - pressure.begin()[i]);
      for (unsigned int k = 0; k < region.dilatations.size(); ++k)
      {
        const BranchCoefficients c =
            step.branch(materials[r].compression.bulk_branches()[k].relaxation_time);
        const double *const present = region.dilatations[k].present.begin();
        double *const next = region.dilatations[k].older.begin();
        for (const unsigned int i : region.nodes)
        {
          const double at_level = c.velocity * level_rate[i] + c.old * present[i] +
                                  c.older * next[i] + c.velocity_old * rate[i];
          next[i] = step.extrapolate ? 2. * at_level - present[i] : at_level;
        }
        region.dilatations[k].present.swap(region.dilatations[k].older);
      }
      for (const unsigned int i : region.nodes)
        rate[i] = step.extrapolate ? 2. * level_rate[i] - rate[i] : level_rate[i];
    }
}

void BulkHistory::balanced_dilatation(const unsigned int r,
                                      const unsigned int branch,
                                      const Step &step,
                                      DistributedVector &dilatation) const
{
  const Dilatation &of_branch = of_region[r].dilatations[branch];
  for (const unsigned int i : of_region[r].nodes)
    dilatation.begin()[i] = step.extrapolate
                                ? 0.5 * (of_branch.present.begin()[i] + of_branch.older.begin()[i])
                                : of_branch.present.begin()[i];
}

void BulkHistory::forgotten_rate(const unsigned int r,
                                 const unsigned int branch,
                                 const Step &step,
                                 DistributedVector &forgotten) const
{
  const double relaxation_time = materials[r].compression.bulk_branches()[branch].relaxation_time;
  if (!step.branch_is_exponential(relaxation_time))
  {
    balanced_dilatation(r, branch, step, forgotten);
    for (const unsigned int i : of_region[r].nodes)
      forgotten.begin()[i] /= relaxation_time;
    return;
  }
  // The exponential update obeys the equation over the step as a whole.
  const Dilatation &of_branch = of_region[r].dilatations[branch];
  for (const unsigned int i : of_region[r].nodes)
    forgotten.begin()[i] =
        of_region[r].balanced_rate.begin()[i] -
        (of_branch.present.begin()[i] - of_branch.older.begin()[i]) / (step.time - step.time_old);
}

void BulkHistory::visit(StateVisitor &visitor)
{
  for (unsigned int r = 0; r < of_region.size(); ++r)
  {
    Region &region = of_region[r];
    for (unsigned int k = 0; k < region.dilatations.size(); ++k)
      visitor.levels({"dilatation of region", r, k}, StateKind::pressure,
                     region.dilatations[k].present, region.dilatations[k].older);
    if (!region.dilatations.empty())
      visitor.vector({"rate of dilatation of region", r}, StateKind::pressure, region.rate);
  }
}
} // namespace Continua
