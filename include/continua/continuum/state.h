#ifndef continua_continuum_state_h
#define continua_continuum_state_h

#include <continua/continuum/branch_history.h>
#include <continua/continuum/cavity_state.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/materials/material.h>

#include <vector>

namespace Continua
{
class WallShearAverage;

/// The vectors that a field is computed from, at the present time; owned entries.
struct State
{
  const DistributedVector &velocity; ///< [m/s]
  const DistributedVector &pressure; ///< [Pa]
  const BranchHistory &history;
  const WallShearAverage *wall_shear = nullptr; ///< null unless the run keeps it
  /// The potentials whose gradients are the directions of walls [1]; null where these are given.
  const DistributedVector *wall_potentials = nullptr;
  /// From the mesh to the shape without stress [m]; null where that is the mesh's.
  const DistributedVector *unloaded_displacement = nullptr;
  /// By unknown pressure; null where there are none.
  const std::vector<CavityState> *cavities = nullptr;
  /// Of a mesh that moves, in the solids that of matter [m]; null where the mesh stays.
  const DistributedVector *mesh_displacement = nullptr;
  /// By region, of a harmonic motion: what stands for eta U + sum_k mu_k D_k; null of steps.
  const std::vector<DistributedVector> *mixtures = nullptr;

  /// By which the body has its present shape [m].
  const DistributedVector &displacement_of_shape() const
  {
    return mesh_displacement != nullptr ? *mesh_displacement : history.displacement();
  }
};

/// Sets `mixture` to w = eta U + sum_k mu_k D_k of a region's material [Pa m]. The region's
/// deviatoric stress is 2 dev sym grad w. Entries outside the region are undefined.
void set_mixture(const State &state,
                 unsigned int region,
                 const Material &material,
                 DistributedVector &mixture);
} // namespace Continua

#endif
