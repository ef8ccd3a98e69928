#include <continua/continuum/stress_free_state.h>

#include <continua/continuum/kinematics.h>
#include <continua/continuum/right_stretch.h>

namespace Continua
{
using namespace dealii;

bool has_directions(const Material &material)
{
  return material.prestretch.exists() ||
         (material.strain_law != nullptr && material.strain_law_parameters.has_fibres());
}

StressFreeState stress_free_state_at(const Material &material,
                                     const TubeDirections &directions,
                                     const double share,
                                     const Tensor<2, 3> &unloaded_gradient)
{
  StressFreeState state;
  if (material.strain_law != nullptr && material.strain_law_parameters.has_fibres())
    state.fibres = material.strain_law_parameters.fibres(directions.axis, directions.circumference);
  state.prestretch = material.prestretch.inverse(directions.axis, directions.circumference, share);
  state.volume_ratio = material.prestretch.volume_ratio(share);
  if (unloaded_gradient.norm_square() == 0.)
    return state;
  const Kinematics unloading(unloaded_gradient);
  state.volume_ratio *= unloading.volume_ratio();
  // Without its turn, so that the directions of the mesh are those of the stress-free piece.
  if (state.volume_ratio > 0.)
    state.prestretch = RightStretch(unloading.deformation_gradient()).inverse() * state.prestretch;
  return state;
}
} // namespace Continua
