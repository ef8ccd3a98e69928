#ifndef continua_materials_holzapfel_gasser_ogden_h
#define continua_materials_holzapfel_gasser_ogden_h

#include <continua/materials/strain_law.h>

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
class HolzapfelGasserOgden : public StrainLaw
{
public:
  /// mu and k1 [Pa], k2 [1], kappa [1] in [0, 1/3]; none is negative.
  HolzapfelGasserOgden(double shear_modulus,
                       double fibre_stiffness,
                       double fibre_exponent,
                       double dispersion);

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
};
} // namespace Continua

#endif
