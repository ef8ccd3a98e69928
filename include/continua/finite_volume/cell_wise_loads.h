#ifndef continua_finite_volume_cell_wise_loads_h
#define continua_finite_volume_cell_wise_loads_h

#include <continua/continuum/load_list.h>
#include <continua/finite_volume/face_conditions.h>

#include <array>
#include <vector>

namespace Continua
{
/// The loads in the momentum equations: body forces on cells, tractions on faces, at the cells' and
/// faces' centres.
template <int dim>
class CellWiseLoads : public LoadList
{
public:
  CellWiseLoads(const CellWiseSpace<dim> &space,
                const Problem &problem,
                const FaceConditions<dim> &face_conditions)
      : LoadList(problem), space(space), face_conditions(face_conditions)
  {
  }

  /// Area times normal at the faces of a condition: the flow rate out of the body that each
  /// velocity stands for [m^2].
  DistributedVector flow_of_velocities(unsigned int condition) const;

private:
  using Item = LoadList::Item;
  using LoadList::problem;
  const CellWiseSpace<dim> &space;
  const FaceConditions<dim> &face_conditions;

  DistributedVector zero_forces() const override { return space.velocity_vector(); }
  void integrate(const Item &item,
                 const Waveform *waveform,
                 double time,
                 DistributedVector &forces) const override;
  std::vector<std::array<double, 3>> places(const Item &item) const override;
};
} // namespace Continua

#endif
