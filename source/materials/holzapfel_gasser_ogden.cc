#include <continua/materials/holzapfel_gasser_ogden.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

HolzapfelGasserOgden::HolzapfelGasserOgden(const double shear_modulus,
                                           const double fibre_stiffness,
                                           const double fibre_exponent,
                                           const double dispersion)
    : modulus(shear_modulus),
      stiffness(fibre_stiffness),
      exponent(fibre_exponent),
      dispersion(dispersion)
{
}

void HolzapfelGasserOgden::set_stress(const PointStrain &strain,
                                      SymmetricTensor<2, 3> &stress) const
{
  set_stress<double>(strain, stress);
}

void HolzapfelGasserOgden::set_tangent(const PointStrain &strain,
                                       SymmetricTensor<2, 3> &stress,
                                       SymmetricTensor<4, 3> &tangent) const
{
  set_tangent<double>(strain, stress, tangent);
}

double HolzapfelGasserOgden::energy(const PointStrain &strain) const
{
  const IsochoricStrain isochoric(strain);
  double sum = 0.5 * modulus * isochoric.first_excess;
  for (const Tensor<1, 3> &direction : strain.fibres)
  {
    const double e = fibre_strain(strain, isochoric, direction).strain;
    if (e > 0.)
      sum += 0.5 * stiffness * (exponent > 0. ? std::expm1(exponent * e * e) / exponent : e * e);
  }
  return sum;
}
} // namespace Continua
