#ifndef continua_continuum_stress_free_state_h
#define continua_continuum_stress_free_state_h

#include <continua/continuum/tube_directions.h>
#include <continua/materials/material.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace Continua
{
/// What a solid is like at a place of the mesh when it is free of stress.
struct StressFreeState
{
  /// Unit directions of the fibres, from the axis towards the circumference; empty for a law
  /// without fibres.
  std::vector<dealii::Tensor<1, 3>> fibres;
  /// F0^-1 [1]: see Prestretch. Where D0 leads from the mesh to the unloaded shape, after U0^-1 of
  /// 1 + Grad D0 = R0 U0: a stress-free piece is turned back, with its fibres and its prestretch.
  dealii::Tensor<2, 3> prestretch;
  /// det F0: the volume free of stress over that of the mesh [1].
  double volume_ratio = 1.;
};

/// Whether a material has fibres or a prestretch, which need directions of the wall.
bool has_directions(const Material &material);

/// `directions`: of the mesh, along and around which fibres lie without stress; `share`: how much
/// of the prestretch there is, 0 to 1; `unloaded_gradient`: Grad D0 by the mesh [1]. Where D0 turns
/// the body inside out the volume ratio is not positive, and F0^-1 means nothing.
StressFreeState stress_free_state_at(const Material &material,
                                     const TubeDirections &directions,
                                     double share = 1.,
                                     const dealii::Tensor<2, 3> &unloaded_gradient = {});
} // namespace Continua

#endif
