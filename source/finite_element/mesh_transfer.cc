#include <continua/finite_element/mesh_transfer.h>

namespace Continua
{
namespace
{
std::vector<const DistributedVector *> pointers_to(const std::vector<DistributedVector> &vectors)
{
  std::vector<const DistributedVector *> pointers;
  for (const DistributedVector &vector : vectors)
    pointers.push_back(&vector);
  return pointers;
}
} // namespace

template <int dim>
void MeshTransfer<dim>::prepare(const std::vector<DistributedVector *> &velocities,
                                const std::vector<DistributedVector *> &pressures)
{
  old_velocities.clear();
  old_pressures.clear();
  for (const DistributedVector *vector : velocities)
    old_velocities.push_back(space.ghosted_velocity(*vector));
  for (const DistributedVector *vector : pressures)
    old_pressures.push_back(space.ghosted_pressure(*vector));
  velocity_transfer = std::make_unique<Transfer>(space.velocity_dofs);
  pressure_transfer = std::make_unique<Transfer>(space.pressure_dofs);
  velocity_transfer->prepare_for_coarsening_and_refinement(pointers_to(old_velocities));
  pressure_transfer->prepare_for_coarsening_and_refinement(pointers_to(old_pressures));
}

template <int dim>
void MeshTransfer<dim>::finish(const std::vector<DistributedVector *> &velocities,
                               const std::vector<DistributedVector *> &pressures)
{
  std::vector<DistributedVector *> targets = velocities;
  velocity_transfer->interpolate(targets);
  targets = pressures;
  pressure_transfer->interpolate(targets);
  // Owned vectors keep nothing at hanging nodes: the matrices have those condensed.
  for (DistributedVector *vector : velocities)
    space.set_hanging_velocities_to_zero(*vector);
  for (DistributedVector *vector : pressures)
    space.set_hanging_pressures_to_zero(*vector);
  velocity_transfer.reset();
  pressure_transfer.reset();
  old_velocities.clear();
  old_pressures.clear();
}

template class MeshTransfer<2>;
template class MeshTransfer<3>;
} // namespace Continua
