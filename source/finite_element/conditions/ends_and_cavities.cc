#include <continua/finite_element/conditions/ends_and_cavities.h>

#include <continua/finite_element/conditions/flow_shapes.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

namespace
{
/// The conditions of the sections that move: ports of outlets, and those of free flow rates.
std::vector<unsigned int> moving_sections(const Problem &problem)
{
  std::vector<unsigned int> conditions;
  for (const Outlet &outlet : problem.outlets)
    if (problem.mesh_moves)
      conditions.insert(conditions.end(), outlet.conditions.begin(), outlet.conditions.end());
  for (unsigned int c = 0; c < problem.conditions.size(); ++c)
    if (problem.conditions[c].free_flow)
      conditions.push_back(c);
  return conditions;
}
} // namespace

template <int dim>
EndsAndCavities<dim>::EndsAndCavities(const Space<dim> &space,
                                      const Problem &problem,
                                      const Loads<dim> &loads)
    : space(space),
      problem(problem),
      loads(loads),
      sections(moving_sections(problem)),
      section_faces(space, problem, sections),
      cavity_volumes(space, problem)
{
}

template <int dim>
void EndsAndCavities<dim>::reinit()
{
  section_faces.reinit();
  cavity_volumes.reinit();
}

template <int dim>
void EndsAndCavities<dim>::set_flow_of_velocities(const unsigned int condition,
                                                  const DistributedVector &mesh_displacement,
                                                  DistributedVector &flow)
{
  section_faces.take(mesh_displacement);
  section_faces.set_flow(std::find(sections.begin(), sections.end(), condition) - sections.begin(),
                         flow);
}

template <int dim>
DistributedVector EndsAndCavities<dim>::flow_profile(const unsigned int condition) const
{
  DistributedVector profile = space.velocity_vector();
  for (const auto &[dof, shape] : nodal_flow_shapes(space, problem.conditions[condition]))
    profile[dof] = shape.front();
  profile.compress(VectorOperation::insert);
  return profile;
}

template class EndsAndCavities<2>;
template class EndsAndCavities<3>;
} // namespace Continua
