#ifndef continua_materials_mooney_rivlin_h
#define continua_materials_mooney_rivlin_h

#include <continua/base/deviatoric_part.h>
#include <continua/materials/isochoric_strain.h>
#include <continua/materials/isochoric_stress.h>
#include <continua/materials/strain_law.h>

namespace Continua
{
/**
 * tau = dev(mu1 Bb + mu2 (tr(Bb) Bb - Bb^2)), energy mu1/2 (I1 - 3) + mu2/2 (I2 - 3) with the
 * invariants I1 = tr Bb and I2 = (I1^2 - tr Bb^2)/2 of Bb = J^-2/3 F F^T (Mooney, J. Appl. Phys. 11
 * (1940) 582; Rivlin, Phil. Trans. R. Soc. A 241 (1948) 379). mu2 = 0 is neo-Hookean.
 */
class MooneyRivlin final : public StrainLaw
{
public:
  /// mu1 and mu2 [Pa], neither negative.
  MooneyRivlin(double first_modulus, double second_modulus);

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
  double shear_modulus() const override { return first_modulus + second_modulus; }

private:
  double first_modulus;  ///< mu1 [Pa]
  double second_modulus; ///< mu2 [Pa]
};
template <typename Number>
void MooneyRivlin::set_stress(const PointStrainOf<Number> &strain,
                              dealii::SymmetricTensor<2, 3, Number> &stress) const
{
  const dealii::SymmetricTensor<2, 3, Number> b = IsochoricStrainOf<Number>(strain).left;
  stress =
      deviatoric_part((first_modulus + second_modulus * trace(b)) * b - second_modulus * square(b));
}

template <typename Number>
void MooneyRivlin::set_tangent(const PointStrainOf<Number> &strain,
                               dealii::SymmetricTensor<2, 3, Number> &stress,
                               dealii::SymmetricTensor<4, 3, Number> &tangent) const
{
  const dealii::SymmetricTensor<2, 3, Number> b = IsochoricStrainOf<Number>(strain).left;
  const dealii::SymmetricTensor<2, 3, Number> fictitious =
      (first_modulus + second_modulus * trace(b)) * b - second_modulus * square(b);
  stress = deviatoric_part(fictitious);
  tangent = isochoric_tangent(trace(fictitious), stress) +
            2. * second_modulus * deviator_of_both(dyadic_product(b, b) - both_sides_product(b));
}
} // namespace Continua

#endif
