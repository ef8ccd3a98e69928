#include <continua/materials/holzapfel_gasser_ogden.h>

#include <continua/materials/isochoric_strain.h>
#include <continua/materials/isochoric_stress.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
/// One family of fibres.
struct FibreStrain
{
  SymmetricTensor<2, 3> structure; ///< H [1]
  double strain;                   ///< E = tr H - 1 [1]
};

FibreStrain fibre_strain(const PointStrain &strain,
                         const IsochoricStrain &isochoric,
                         const Tensor<1, 3> &direction,
                         const double dispersion)
{
  const Tensor<1, 3> fibre = strain.gradient * direction;
  const double aligned = 1. - 3. * dispersion;
  // E by tr Bb - 3: an isotropic family has one of second order in the strain.
  return {dispersion * isochoric.left +
              aligned * isochoric.factor * symmetrize(outer_product(fibre, fibre)),
          dispersion * isochoric.first_excess +
              aligned * (isochoric.factor * fibre.norm_square() - 1.)};
}
} // namespace

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
  const IsochoricStrain isochoric(strain);
  stress = modulus * isochoric.left;
  for (const Tensor<1, 3> &direction : strain.fibres)
  {
    const FibreStrain fibre = fibre_strain(strain, isochoric, direction, dispersion);
    const double e = fibre.strain;
    if (e > 0.)
      stress += 2. * stiffness * e * std::exp(exponent * e * e) * fibre.structure;
  }
  stress = deviator(stress);
}

void HolzapfelGasserOgden::set_tangent(const PointStrain &strain,
                                       SymmetricTensor<2, 3> &stress,
                                       SymmetricTensor<4, 3> &tangent) const
{
  const IsochoricStrain isochoric(strain);
  SymmetricTensor<2, 3> fictitious = modulus * isochoric.left;
  SymmetricTensor<4, 3> of_fibres;
  for (const Tensor<1, 3> &direction : strain.fibres)
  {
    const FibreStrain fibre = fibre_strain(strain, isochoric, direction, dispersion);
    const double e = fibre.strain;
    if (e <= 0.)
      continue;
    const double growth = std::exp(exponent * e * e);
    fictitious += 2. * stiffness * e * growth * fibre.structure;
    const SymmetricTensor<2, 3> deviatoric = deviator(fibre.structure);
    of_fibres += 4. * stiffness * (1. + 2. * exponent * e * e) * growth *
                 dyadic_product(deviatoric, deviatoric);
  }
  stress = deviator(fictitious);
  tangent = isochoric_tangent(trace(fictitious), stress) + of_fibres;
}

double HolzapfelGasserOgden::energy(const PointStrain &strain) const
{
  const IsochoricStrain isochoric(strain);
  double sum = 0.5 * modulus * isochoric.first_excess;
  for (const Tensor<1, 3> &direction : strain.fibres)
  {
    const double e = fibre_strain(strain, isochoric, direction, dispersion).strain;
    if (e > 0.)
      sum += 0.5 * stiffness * (exponent > 0. ? std::expm1(exponent * e * e) / exponent : e * e);
  }
  return sum;
}
} // namespace Continua
