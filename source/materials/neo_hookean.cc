#include <continua/materials/neo_hookean.h>

namespace Continua
{
using namespace dealii;

NeoHookean::NeoHookean(const double shear_modulus) : modulus(shear_modulus) {}

void NeoHookean::set_stress(const PointStrain &strain, SymmetricTensor<2, 3> &stress) const
{
  set_stress<double>(strain, stress);
}

void NeoHookean::set_tangent(const PointStrain &strain,
                             SymmetricTensor<2, 3> &stress,
                             SymmetricTensor<4, 3> &tangent) const
{
  set_tangent<double>(strain, stress, tangent);
}

double NeoHookean::energy(const PointStrain &strain) const
{
  return 0.5 * modulus * IsochoricStrain(strain).first_excess;
}
} // namespace Continua
