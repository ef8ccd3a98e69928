#include <continua/continuum/state.h>

namespace Continua
{
void set_mixture(const State &state,
                 const unsigned int region,
                 const Material &material,
                 DistributedVector &mixture)
{
  if (state.mixtures != nullptr)
  {
    mixture.equ(1., (*state.mixtures)[region]);
    return;
  }
  mixture = 0.;
  state.history.mix(region, mixture);
  if (material.shear.viscosity != 0.)
    mixture.add(material.shear.viscosity, state.velocity);
}
} // namespace Continua
