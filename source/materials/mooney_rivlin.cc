#include <continua/materials/mooney_rivlin.h>

#include <continua/materials/isochoric_strain.h>
#include <continua/materials/isochoric_stress.h>

namespace Continua
{
using namespace dealii;

MooneyRivlin::MooneyRivlin(const double first_modulus, const double second_modulus)
    : first_modulus(first_modulus), second_modulus(second_modulus)
{
}

void MooneyRivlin::set_stress(const PointStrain &strain, SymmetricTensor<2, 3> &stress) const
{
  const SymmetricTensor<2, 3> b = IsochoricStrain(strain).left;
  stress = deviator((first_modulus + second_modulus * trace(b)) * b - second_modulus * square(b));
}

void MooneyRivlin::set_tangent(const PointStrain &strain,
                               SymmetricTensor<2, 3> &stress,
                               SymmetricTensor<4, 3> &tangent) const
{
  const SymmetricTensor<2, 3> b = IsochoricStrain(strain).left;
  const SymmetricTensor<2, 3> fictitious =
      (first_modulus + second_modulus * trace(b)) * b - second_modulus * square(b);
  stress = deviator(fictitious);
  tangent = isochoric_tangent(trace(fictitious), stress) +
            2. * second_modulus * deviator_of_both(dyadic_product(b, b) - both_sides_product(b));
}

double MooneyRivlin::energy(const PointStrain &strain) const
{
  const IsochoricStrain isochoric(strain);
  return 0.5 *
         (first_modulus * isochoric.first_excess + second_modulus * isochoric.second_excess());
}
} // namespace Continua
