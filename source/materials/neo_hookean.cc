#include <continua/materials/neo_hookean.h>

#include <continua/materials/isochoric_strain.h>
#include <continua/materials/isochoric_stress.h>

namespace Continua
{
using namespace dealii;

NeoHookean::NeoHookean(const double shear_modulus) : modulus(shear_modulus) {}

void NeoHookean::set_stress(const PointStrain &strain, SymmetricTensor<2, 3> &stress) const
{
  stress = modulus * deviator(IsochoricStrain(strain).left);
}

void NeoHookean::set_tangent(const PointStrain &strain,
                             SymmetricTensor<2, 3> &stress,
                             SymmetricTensor<4, 3> &tangent) const
{
  const IsochoricStrain isochoric(strain);
  stress = modulus * deviator(isochoric.left);
  tangent = isochoric_tangent(modulus * trace(isochoric.left), stress);
}

double NeoHookean::energy(const PointStrain &strain) const
{
  return 0.5 * modulus * IsochoricStrain(strain).first_excess;
}
} // namespace Continua
