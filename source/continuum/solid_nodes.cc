#include <continua/continuum/solid_nodes.h>

namespace Continua
{
SolidNodes::SolidNodes(const Problem &problem, const Operators &operators)
    : problem(problem), operators(operators)
{
}

std::vector<bool> SolidNodes::have_branches(const DistributedVector &vector) const
{
  std::vector<bool> result(vector.locally_owned_size(), false);
  const std::vector<std::vector<unsigned int>> nodes = operators.velocity_nodes();
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (!problem.materials[region].shear.branches.empty())
      for (const unsigned int i : nodes[region])
        result[i] = true;
  return result;
}

void SolidNodes::clear(DistributedVector &vector) const
{
  const std::vector<bool> of_solids = have_branches(vector);
  for (unsigned int i = 0; i < of_solids.size(); ++i)
    if (of_solids[i])
      vector.begin()[i] = 0.;
}

void SolidNodes::clear_others(DistributedVector &vector) const
{
  const std::vector<bool> of_solids = have_branches(vector);
  for (unsigned int i = 0; i < of_solids.size(); ++i)
    if (!of_solids[i])
      vector.begin()[i] = 0.;
}

void SolidNodes::clear_finite(DistributedVector &vector) const
{
  if (!problem.has_regions_of(RegionModel::finite_solid))
    return;
  const std::vector<std::vector<unsigned int>> nodes = operators.velocity_nodes();
  for (unsigned int region = 0; region < problem.materials.size(); ++region)
    if (problem.region_model(region) == RegionModel::finite_solid)
      for (const unsigned int i : nodes[region])
        vector.begin()[i] = 0.;
}
} // namespace Continua
