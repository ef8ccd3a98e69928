#ifndef continua_materials_holzapfel_gasser_ogden_h
#define continua_materials_holzapfel_gasser_ogden_h

#include <continua/base/deviatoric_part.h>
#include <continua/base/of_each.h>
#include <continua/materials/isochoric_strain.h>
#include <continua/materials/isochoric_stress.h>
#include <continua/materials/strain_law.h>

#include <deal.II/base/vectorization.h>

#include <cmath>

namespace Continua
{
/**
 * Neo-Hookean matter with families of fibres that bear tension only:
 *
 *   tau = dev(mu Bb + sum_i 2 psi_i H_i),   psi_i = k1 E_i exp(k2 E_i^2),
 *   H_i = kappa Bb + (1 - 3 kappa) f_i f_i^T,   E_i = tr H_i - 1,   f_i = J^-1/3 F a_i
 *
 * for the directions a_i of PointStrain::fibres; psi_i is 0 unless E_i > 0. The energy is
 * mu/2 (tr Bb - 3) + sum_i k1/(2 k2) (exp(k2 E_i^2) - 1). kappa is the dispersion of the directions
 * of a family: 0 - all alike, 1/3 - isotropic (Gasser, Ogden and Holzapfel, J. R. Soc. Interface 3
 * (2006) 15). k2 = 0 is the limit of fibres that do not stiffen.
 */
class HolzapfelGasserOgden final : public StrainLaw
{
public:
  /// mu and k1 [Pa], k2 [1], kappa [1] in [0, 1/3]; none is negative.
  HolzapfelGasserOgden(double shear_modulus,
                       double fibre_stiffness,
                       double fibre_exponent,
                       double dispersion);

  /// As of StrainLaw.
  template <typename Number>
  void set_stress(const PointStrainOf<Number> &strain,
                  dealii::SymmetricTensor<2, 3, Number> &stress) const;
  template <typename Number>
  void set_tangent(const PointStrainOf<Number> &strain,
                   dealii::SymmetricTensor<2, 3, Number> &stress,
                   dealii::SymmetricTensor<4, 3, Number> &tangent) const;
  void set_stress(const PointStrain &strain, dealii::SymmetricTensor<2, 3> &stress) const override;
  void set_tangent(const PointStrain &strain,
                   dealii::SymmetricTensor<2, 3> &stress,
                   dealii::SymmetricTensor<4, 3> &tangent) const override;
  double energy(const PointStrain &strain) const override;
  double shear_modulus() const override { return modulus; }

private:
  double modulus;    ///< mu [Pa]
  double stiffness;  ///< k1 [Pa]
  double exponent;   ///< k2 [1]
  double dispersion; ///< kappa [1]

  /// One family of fibres.
  template <typename Number>
  struct FibreStrain
  {
    dealii::SymmetricTensor<2, 3, Number> structure; ///< H [1]
    Number strain;                                   ///< E = tr H - 1 [1]
    Number borne;                                    ///< 1 where E > 0, else 0
  };

  template <typename Number>
  FibreStrain<Number> fibre_strain(const PointStrainOf<Number> &strain,
                                   const IsochoricStrainOf<Number> &isochoric,
                                   const dealii::Tensor<1, 3, Number> &direction) const;
  /// exp(k2 E^2).
  template <typename Number>
  Number growth(const Number &strain) const
  {
    return of_each([](const double power) { return std::exp(power); }, exponent * strain * strain);
  }
};
template <typename Number>
typename HolzapfelGasserOgden::FibreStrain<Number>
HolzapfelGasserOgden::fibre_strain(const PointStrainOf<Number> &strain,
                                   const IsochoricStrainOf<Number> &isochoric,
                                   const dealii::Tensor<1, 3, Number> &direction) const
{
  const dealii::Tensor<1, 3, Number> fibre = strain.gradient * direction;
  const double aligned = 1. - 3. * dispersion;
  // E by tr Bb - 3: an isotropic family has one of second order in the strain.
  const Number e =
      dispersion * isochoric.first_excess + aligned * (isochoric.factor * fibre.norm_square() - 1.);
  return {dispersion * isochoric.left +
              aligned * isochoric.factor * symmetrize(outer_product(fibre, fibre)),
          e,
          // Of a fibre that bears nothing the exponential has no use, and might be infinite.
          dealii::compare_and_apply_mask<dealii::SIMDComparison::greater_than>(
              e, Number(0.), Number(1.), Number(0.))};
}

template <typename Number>
void HolzapfelGasserOgden::set_stress(const PointStrainOf<Number> &strain,
                                      dealii::SymmetricTensor<2, 3, Number> &stress) const
{
  const IsochoricStrainOf<Number> isochoric(strain);
  stress = modulus * isochoric.left;
  for (const dealii::Tensor<1, 3, Number> &direction : strain.fibres)
  {
    const FibreStrain<Number> fibre = fibre_strain(strain, isochoric, direction);
    const Number e = fibre.borne * fibre.strain;
    stress += 2. * stiffness * e * growth(e) * fibre.structure;
  }
  stress = deviatoric_part(stress);
}

template <typename Number>
void HolzapfelGasserOgden::set_tangent(const PointStrainOf<Number> &strain,
                                       dealii::SymmetricTensor<2, 3, Number> &stress,
                                       dealii::SymmetricTensor<4, 3, Number> &tangent) const
{
  const IsochoricStrainOf<Number> isochoric(strain);
  dealii::SymmetricTensor<2, 3, Number> fictitious = modulus * isochoric.left;
  dealii::SymmetricTensor<4, 3, Number> of_fibres;
  for (const dealii::Tensor<1, 3, Number> &direction : strain.fibres)
  {
    const FibreStrain<Number> fibre = fibre_strain(strain, isochoric, direction);
    const Number e = fibre.borne * fibre.strain, growth_of_fibre = growth(e);
    fictitious += 2. * stiffness * e * growth_of_fibre * fibre.structure;
    const dealii::SymmetricTensor<2, 3, Number> deviatoric = deviatoric_part(fibre.structure);
    of_fibres += 4. * stiffness * fibre.borne * (1. + 2. * exponent * e * e) * growth_of_fibre *
                 dyadic_product(deviatoric, deviatoric);
  }
  stress = deviatoric_part(fictitious);
  tangent = isochoric_tangent(trace(fictitious), stress) + of_fibres;
}
} // namespace Continua

#endif
