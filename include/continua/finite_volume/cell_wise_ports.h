#ifndef continua_finite_volume_cell_wise_ports_h
#define continua_finite_volume_cell_wise_ports_h

#include <continua/continuum/ports.h>
#include <continua/finite_volume/cell_wise_loads.h>
#include <continua/finite_volume/face_conditions.h>

namespace Continua
{
/// The sections of outlets and of given flow rates, by the faces in them.
template <int dim>
class CellWisePorts : public Ports
{
public:
  /// All must outlive it.
  CellWisePorts(const CellWiseSpace<dim> &space,
                const FaceConditions<dim> &conditions,
                const CellWiseLoads<dim> &loads)
      : space(space), conditions(conditions), loads(loads)
  {
  }

  DistributedVector flow_of_velocities(const unsigned int condition) const override
  {
    return loads.flow_of_velocities(condition);
  }
  DistributedVector flow_profile(unsigned int condition) const override;

private:
  const CellWiseSpace<dim> &space;
  const FaceConditions<dim> &conditions;
  const CellWiseLoads<dim> &loads;
};
} // namespace Continua

#endif
