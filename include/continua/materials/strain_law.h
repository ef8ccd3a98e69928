#ifndef continua_materials_strain_law_h
#define continua_materials_strain_law_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Continua
{
/// The elastic deformation at a point. Gradients are always 3x3 (plane strain: F_33 = 1;
/// axisymmetric: F_33 = 1 + d_R/R).
struct PointStrain
{
  dealii::Tensor<2, 3> gradient;                 ///< F [1]
  double determinant = 1.;                       ///< J = det F [1], positive
  std::vector<dealii::Tensor<1, 3>> fibres = {}; ///< unit directions in the stress-free state
};

/**
 * A hyperelastic law at a point: stress and tangent from the deformation gradient. tau is the
 * deviator of the Kirchhoff stress (J sigma); the pressure is an unknown of its own,
 * p = -tr(sigma)/3. No function allocates memory or changes the law, so that one law serves all
 * points.
 */
class StrainLaw
{
public:
  virtual ~StrainLaw() = default;
  /// tau [Pa].
  virtual void set_stress(const PointStrain &strain,
                          dealii::SymmetricTensor<2, 3> &stress) const = 0;
  /**
   * tau [Pa] and C [Pa], with which a change of place du changes it:
   * d tau = C : e + g tau + tau g^T, g = grad du (spatial), e = sym g. C is the spatial tensor of
   * the Lie derivative of the deviator; it need not have major symmetry.
   */
  virtual void set_tangent(const PointStrain &strain,
                           dealii::SymmetricTensor<2, 3> &stress,
                           dealii::SymmetricTensor<4, 3> &tangent) const = 0;
  /// Energy of the change of shape per reference volume [J/m^3]; of laws with a mean stress of
  /// their own the whole energy.
  virtual double energy(const PointStrain &strain) const = 0;
  /// Shear modulus at rest, of the isotropic part [Pa].
  virtual double shear_modulus() const = 0;
  /// Whether the mean stress follows from the law itself (St. Venant-Kirchhoff) instead of from the
  /// material's volume law ln J + g(p) = 0.
  virtual bool has_own_mean_stress() const { return false; }
  /// For such a law: s = tr(T)/(3 J) [Pa], the mean Cauchy stress of the law, and S [Pa] with
  /// ds = S : e (e = sym grad du). Any other law throws std::logic_error.
  virtual void set_mean_stress(const PointStrain &strain,
                               double &mean_stress,
                               dealii::SymmetricTensor<2, 3> &derivative) const;
  /// Of such a law set_stress() and set_mean_stress() together, at the cost of one of them.
  virtual void set_stresses(const PointStrain &strain,
                            dealii::SymmetricTensor<2, 3> &stress,
                            double &mean_stress,
                            dealii::SymmetricTensor<2, 3> &derivative) const
  {
    set_stress(strain, stress);
    set_mean_stress(strain, mean_stress, derivative);
  }
};
} // namespace Continua

#endif
