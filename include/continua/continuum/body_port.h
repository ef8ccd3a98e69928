#ifndef continua_continuum_body_port_h
#define continua_continuum_body_port_h

#include <continua/continuum/operators.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/sparse_entries.h>

namespace Continua
{
/**
 * A section of the body before an outlet: what holds it, what it gives back, and the response of
 * the body to it alone. A port either holds the pressure p, which acts as the force -q p with
 * q_i = int v_i . n, and gives back its flow rate q . U; or it holds the flow rate Q by the
 * velocity phi Q, where the flow of phi is 1, and gives back its pressure by virtual power,
 * p = -phi . (A U + G p - f).
 */
struct BodyPort
{
  /// Of the condition `condition`, before `outlet`, on the present mesh.
  BodyPort(const Problem &problem,
           Operators &operators,
           unsigned int outlet,
           unsigned int condition);

  unsigned int outlet;
  unsigned int condition;
  bool holds_flow;
  bool moves_with_mesh;           ///< its flow rate is that past a mesh that moves
  SparseEntries flow;             ///< q [m^2], of a mesh that moves at the last iterate
  SparseEntries velocity;         ///< phi [1/m^2]; of a port that holds the flow rate
  double square_of_velocity = 0.; ///< phi . phi [1/m^4]
  SparseEntries momentum_of_velocity, mass_of_velocity; ///< A^T phi and -G^T phi
  DistributedVector velocity_response, pressure_response;
  double force = 0.; ///< phi . f of this rank

  /// This rank's part of what it gives back, but for `force`: [Pa] or [m^3/s].
  double output(const DistributedVector &of_velocity, const DistributedVector &of_pressure) const;
};
} // namespace Continua

#endif
