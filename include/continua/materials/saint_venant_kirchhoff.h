#ifndef continua_materials_saint_venant_kirchhoff_h
#define continua_materials_saint_venant_kirchhoff_h

#include <continua/materials/strain_law.h>

namespace Continua
{
/**
 * Linear in Green's strain E = (F^T F - 1)/2: Kirchhoff stress T = F (lambda tr(E) 1 + 2 mu E) F^T,
 * of which tau is the deviator and tr(T)/(3 J) the mean Cauchy stress; energy
 * lambda/2 tr^2(E) + mu E : E. Under strong compression it becomes unstable: its stress vanishes at
 * F = 0.
 */
class SaintVenantKirchhoff : public StrainLaw
{
public:
  /// mu [Pa], positive, and Lame's lambda = K - 2/3 mu [Pa], finite.
  SaintVenantKirchhoff(double shear_modulus, double lambda);

  void set_stress(const PointStrain &strain, dealii::SymmetricTensor<2, 3> &stress) const override;
  void set_tangent(const PointStrain &strain,
                   dealii::SymmetricTensor<2, 3> &stress,
                   dealii::SymmetricTensor<4, 3> &tangent) const override;
  double energy(const PointStrain &strain) const override;
  double shear_modulus() const override { return modulus; }
  bool has_own_mean_stress() const override { return true; }
  void set_mean_stress(const PointStrain &strain,
                       double &mean_stress,
                       dealii::SymmetricTensor<2, 3> &derivative) const override;
  void set_stresses(const PointStrain &strain,
                    dealii::SymmetricTensor<2, 3> &stress,
                    double &mean_stress,
                    dealii::SymmetricTensor<2, 3> &derivative) const override;

private:
  double modulus; ///< mu [Pa]
  double lambda;  ///< [Pa]

  /// T [Pa].
  dealii::SymmetricTensor<2, 3> whole_stress(const PointStrain &strain) const;
  /// Of T at this strain.
  void set_mean_of(const dealii::SymmetricTensor<2, 3> &whole,
                   const PointStrain &strain,
                   double &mean_stress,
                   dealii::SymmetricTensor<2, 3> &derivative) const;
};
} // namespace Continua

#endif
