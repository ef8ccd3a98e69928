#ifndef continua_finite_element_mesh_transfer_h
#define continua_finite_element_mesh_transfer_h

#include <continua/finite_element/space/solution_transfer.h>
#include <continua/finite_element/space/space.h>

#include <memory>
#include <vector>

namespace Continua
{
/// Carries vectors of both spaces over a change of the mesh (distributed triangulations).
template <int dim>
class MeshTransfer
{
public:
  explicit MeshTransfer(const Space<dim> &space) : space(space) {}

  /// Call when cells are flagged and before the triangulation changes.
  void prepare(const std::vector<DistributedVector *> &velocities,
               const std::vector<DistributedVector *> &pressures);
  /// Call when the space is distributed on the new mesh; fills the vectors (of the new size) in the
  /// same order.
  void finish(const std::vector<DistributedVector *> &velocities,
              const std::vector<DistributedVector *> &pressures);

private:
  using Transfer = SolutionTransfer<dim, DistributedVector>;
  const Space<dim> &space;
  std::unique_ptr<Transfer> velocity_transfer, pressure_transfer;
  std::vector<DistributedVector> old_velocities, old_pressures; ///< with ghosts
};
} // namespace Continua

#endif
