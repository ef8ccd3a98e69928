#ifndef continua_materials_neo_hookean_h
#define continua_materials_neo_hookean_h

#include <continua/base/deviatoric_part.h>
#include <continua/materials/isochoric_strain.h>
#include <continua/materials/isochoric_stress.h>
#include <continua/materials/strain_law.h>

namespace Continua
{
/// tau = mu dev Bb, energy mu/2 (tr Bb - 3), Bb = J^-2/3 F F^T.
class NeoHookean final : public StrainLaw
{
public:
  /// mu [Pa], positive.
  explicit NeoHookean(double shear_modulus);

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
  double modulus; ///< mu [Pa]
};
template <typename Number>
void NeoHookean::set_stress(const PointStrainOf<Number> &strain,
                            dealii::SymmetricTensor<2, 3, Number> &stress) const
{
  stress = modulus * deviatoric_part(IsochoricStrainOf<Number>(strain).left);
}

template <typename Number>
void NeoHookean::set_tangent(const PointStrainOf<Number> &strain,
                             dealii::SymmetricTensor<2, 3, Number> &stress,
                             dealii::SymmetricTensor<4, 3, Number> &tangent) const
{
  const IsochoricStrainOf<Number> isochoric(strain);
  stress = modulus * deviatoric_part(isochoric.left);
  tangent = isochoric_tangent<Number>(modulus * trace(isochoric.left), stress);
}
} // namespace Continua

#endif
