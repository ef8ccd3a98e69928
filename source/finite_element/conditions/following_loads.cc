#include <continua/finite_element/conditions/following_loads.h>
#include <continua/mesh/coordinates.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Continua
{
using namespace dealii;

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
  // The matter of a solid keeps its mass and its undeformed volume.
  if (!problem.materials[region].is_solid())
    return !interior.acceleration.empty() || !interior.body_force.empty();
  return body_force_depends_on_space(interior);
}

template <int dim>
Tensor<1, dim> body_force_at(const Problem &problem,
                             const unsigned int region,
                             const Point<dim> &place,
                             const Step &step)
{
  const std::array<double, 3> x = coordinates(place);
  const InteriorData &interior = problem.interior;
  Tensor<1, dim> force;
  for (unsigned int c = 0; c < interior.acceleration.size(); ++c)
    force[c] +=
        problem.materials[region].density * interior.acceleration[c](x.data(), step.balance_time);
  for (unsigned int c = 0; c < interior.body_force.size(); ++c)
    force[c] += interior.body_force[c](x.data(), step.balance_time);
  return step.load_factor * force;
}

bool traction_follows(const Problem &problem,
                      const unsigned int region,
                      const BoundaryPart &part,
                      const bool along_normal)
{
  // A pressure is normal to the present face of a solid; a traction is that of its undeformed face.
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

template Tensor<1, 2>
body_force_at<2>(const Problem &, unsigned int, const Point<2> &, const Step &);
template Tensor<1, 3>
body_force_at<3>(const Problem &, unsigned int, const Point<3> &, const Step &);
} // namespace Continua
