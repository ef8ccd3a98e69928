#ifndef continua_materials_mooney_rivlin_h
#define continua_materials_mooney_rivlin_h

#include <continua/materials/strain_law.h>

namespace Continua
{
/**
 * tau = dev(mu1 Bb + mu2 (tr(Bb) Bb - Bb^2)), energy mu1/2 (I1 - 3) + mu2/2 (I2 - 3) with the
 * invariants I1 = tr Bb and I2 = (I1^2 - tr Bb^2)/2 of Bb = J^-2/3 F F^T (Mooney, J. Appl. Phys. 11
 * (1940) 582; Rivlin, Phil. Trans. R. Soc. A 241 (1948) 379). mu2 = 0 is neo-Hookean.
 */
class MooneyRivlin : public StrainLaw
{
public:
  /// mu1 and mu2 [Pa], neither negative.
  MooneyRivlin(double first_modulus, double second_modulus);

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
} // namespace Continua

#endif
