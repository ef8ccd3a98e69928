#include <continua/finite_element/conditions/following_loads.h>

#include <algorithm>
#include <vector>

namespace Continua
{
bool body_force_depends_on_space(const InteriorData &interior)
{
  const auto depends = [](const std::vector<Waveform> &components)
  {
    return std::any_of(components.begin(), components.end(),
                       [](const Waveform &component) { return component.depends_on_space(); });
  };
  return depends(interior.acceleration) || depends(interior.body_force);
}

bool body_force_follows(const Problem &problem, const unsigned int region)
{
  if (!problem.is_deformed(region))
    return false;
  const InteriorData &interior = problem.interior;
  // The matter of a solid keeps its mass and its volume at rest.
  if (!problem.materials[region].is_solid())
    return !interior.acceleration.empty() || !interior.body_force.empty();
  return body_force_depends_on_space(interior);
}

bool traction_follows(const Problem &problem,
                      const unsigned int region,
                      const BoundaryPart &part,
                      const bool along_normal)
{
  // A pressure is normal to the present face of a solid; a traction is that of its face at rest.
  return problem.is_deformed(region) &&
         (!problem.materials[region].is_solid() || (along_normal && part.negative));
}

bool has_following_traction(const Problem &problem,
                            const unsigned int region,
                            const BoundaryCondition &condition)
{
  const auto has = [&](const BoundaryPart &part)
  {
    return part.kind == BoundaryPart::Kind::traction &&
           ((!part.along_normal.is_zero() && traction_follows(problem, region, part, true)) ||
            (!part.vector.empty() && traction_follows(problem, region, part, false)));
  };
  return has(condition.normal) || has(condition.tangential);
}
} // namespace Continua
