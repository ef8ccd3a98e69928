#include <continua/materials/mooney_rivlin.h>

namespace Continua
{
using namespace dealii;

MooneyRivlin::MooneyRivlin(const double first_modulus, const double second_modulus)
    : first_modulus(first_modulus), second_modulus(second_modulus)
{
}

void MooneyRivlin::set_stress(const PointStrain &strain, SymmetricTensor<2, 3> &stress) const
{
  set_stress<double>(strain, stress);
}

void MooneyRivlin::set_tangent(const PointStrain &strain,
                               SymmetricTensor<2, 3> &stress,
                               SymmetricTensor<4, 3> &tangent) const
{
  set_tangent<double>(strain, stress, tangent);
}

double MooneyRivlin::energy(const PointStrain &strain) const
{
  const IsochoricStrain isochoric(strain);
  return 0.5 *
         (first_modulus * isochoric.first_excess + second_modulus * isochoric.second_excess());
}
} // namespace Continua
