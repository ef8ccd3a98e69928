#ifndef continua_continuum_wall_shear_h
#define continua_continuum_wall_shear_h

#include <continua/continuum/state.h>
#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/// The wall shear stress at the nodes of the walls. Vectors are as the velocities.
class WallShear
{
public:
  virtual ~WallShear() = default;

  /// Sets the tangential part of the traction of the liquids on their walls at this rank's nodes
  /// there, 0 at others [Pa]. Collective.
  virtual void set(const State &state, DistributedVector &shear) = 0;
  /// Sets each component of a wall's node to the magnitude of the vector there, others to 0.
  virtual void set_magnitudes(const DistributedVector &vectors,
                              DistributedVector &magnitudes) const = 0;
  /// Sets all but the nodes of walls to 0.
  virtual void keep_walls_alone(DistributedVector &vector) const = 0;
};
} // namespace Continua

#endif
