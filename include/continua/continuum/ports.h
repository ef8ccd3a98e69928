#ifndef continua_continuum_ports_h
#define continua_continuum_ports_h

#include <continua/linear_algebra/distributed_vector.h>

#include <deal.II/base/exceptions.h>

namespace Continua
{
/// The sections of a body through which a flow rate is known: outlets, and inlets with a profile.
/// `condition`: the number of their boundary condition.
class Ports
{
public:
  virtual ~Ports() = default;

  /// int v . n over the faces of a boundary condition: the flow rate out of the body that each
  /// velocity stands for [m^2].
  virtual DistributedVector flow_of_velocities(unsigned int condition) const = 0;
  /// The same over the present faces of an outlet's port, at a displacement of a mesh that moves
  /// with the solids [m].
  virtual void set_flow_of_velocities(unsigned int /*condition*/,
                                      const DistributedVector & /*mesh_displacement*/,
                                      DistributedVector & /*flow*/)
  {
    AssertThrow(false, dealii::ExcNotImplemented());
  }
  /// The velocity along x of the flow profile of a condition, of any size.
  virtual DistributedVector flow_profile(unsigned int condition) const = 0;
};
} // namespace Continua

#endif
