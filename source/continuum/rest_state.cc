#include <continua/continuum/rest_state.h>

#include <continua/continuum/kinematics.h>

namespace Continua
{
using namespace dealii;

RestState rest_state_at(const Material &material,
                        const TubeDirections &directions,
                        const double share,
                        const Tensor<2, 3> &unloaded_gradient)
{
  RestState state;
  if (material.strain_law != nullptr && material.strain_law_parameters.has_fibres())
    state.fibres = material.strain_law_parameters.fibres(directions.axis, directions.circumference);
  state.prestretch = material.prestretch.inverse(directions.axis, directions.circumference, share);
  state.volume_ratio = material.prestretch.volume_ratio(share);
  const Kinematics unloading(unloaded_gradient);
  state.unloading = unloading.inverse();
  if (unloaded_gradient.norm_square() == 0.)
    return state;
  state.volume_ratio *= unloading.volume_ratio();
  if (state.volume_ratio > 0.)
    state.prestretch = state.unloading * state.prestretch;
  return state;
}
} // namespace Continua
