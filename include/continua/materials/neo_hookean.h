#ifndef continua_materials_neo_hookean_h
#define continua_materials_neo_hookean_h

#include <continua/materials/strain_law.h>

namespace Continua
{
/// tau = mu dev Bb, energy mu/2 (tr Bb - 3), Bb = J^-2/3 F F^T.
class NeoHookean : public StrainLaw
{
public:
  /// mu [Pa], positive.
  explicit NeoHookean(double shear_modulus);

  void set_stress(const PointStrain &strain, dealii::SymmetricTensor<2, 3> &stress) const override;
  void set_tangent(const PointStrain &strain,
                   dealii::SymmetricTensor<2, 3> &stress,
                   dealii::SymmetricTensor<4, 3> &tangent) const override;
  double energy(const PointStrain &strain) const override;
  double shear_modulus() const override { return modulus; }

private:
  double modulus; ///< mu [Pa]
};
} // namespace Continua

#endif
