#include <continua/continuum/body_port.h>

namespace Continua
{
BodyPort::BodyPort(const Problem &problem,
                   Operators &operators,
                   const unsigned int outlet,
                   const unsigned int condition)
    : outlet(outlet),
      condition(condition),
      holds_flow(problem.conditions[condition].normal.flow != nullptr),
      // The waves that an absorbing end lets pass are those of matter, also of the wall's.
      moves_with_mesh(problem.mesh_moves &&
                      problem.conditions[condition].type != BoundaryType::absorbing),
      velocity_response(operators.velocity_vector()),
      pressure_response(operators.pressure_vector())
{
  const DistributedVector of_section = operators.ports().flow_of_velocities(condition);
  flow = SparseEntries(of_section);
  if (!holds_flow)
    return;
  // A flow of 1 is wanted, out of the body.
  DistributedVector profile = operators.ports().flow_profile(condition);
  profile *= 1. / (of_section * profile);
  velocity = SparseEntries(profile);
  square_of_velocity = profile.norm_sqr();
}

double BodyPort::output(const DistributedVector &of_velocity,
                        const DistributedVector &of_pressure) const
{
  return holds_flow
             ? mass_of_velocity.product(of_pressure) - momentum_of_velocity.product(of_velocity)
             : flow.product(of_velocity);
}
} // namespace Continua
