#ifndef continua_continuum_rest_state_h
#define continua_continuum_rest_state_h

#include <continua/materials/material.h>
#include <continua/materials/model.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Continua
{
/// What a solid is like at a place of the mesh when it is free of stress.
struct RestState
{
  /// Unit directions of the fibres, from the axis towards the circumference; empty for a law
  /// without fibres.
  std::vector<dealii::Tensor<1, 3>> fibres;
  /// F0^-1, see Prestretch [1].
  dealii::Tensor<2, 3> prestretch;
  /// det F0: the volume free of stress over that of the mesh [1].
  double volume_ratio = 1.;
};

/// `share`: how much of the prestretch there is, 0 to 1.
template <int dim>
RestState rest_state_at(const Material &material,
                        Model model,
                        const dealii::Point<dim> &place,
                        double share = 1.);
} // namespace Continua

#endif
