#include <continua/finite_element/conditions/ends_and_cavities.h>

#include <continua/finite_element/conditions/flow_shapes.h>

#include <algorithm>

namespace Continua
{
using namespace dealii;

namespace
{
/// The conditions of the ports of outlets whose faces move.
std::vector<unsigned int> moving_ports(const Problem &problem)
{
  std::vector<unsigned int> conditions;
  for (const Outlet &outlet : problem.outlets)
    if (problem.mesh_moves)
      conditions.insert(conditions.end(), outlet.conditions.begin(), outlet.conditions.end());
  return conditions;
}
} // namespace

template <int dim>
EndsAndCavities<dim>::EndsAndCavities(const Space<dim> &space, const Problem &problem)
    : space(space),
      problem(problem),
      ports(moving_ports(problem)),
      port_faces(space, problem, ports),
      cavities(space, problem)
{
}

template <int dim>
void EndsAndCavities<dim>::reinit()
{
  port_faces.reinit();
  cavities.reinit();
}

template <int dim>
void EndsAndCavities<dim>::set_flow_of_velocities(const unsigned int condition,
                                                  const DistributedVector &mesh_displacement,
                                                  DistributedVector &flow)
{
  port_faces.take(mesh_displacement);
  port_faces.set_flow(std::find(ports.begin(), ports.end(), condition) - ports.begin(), flow);
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
