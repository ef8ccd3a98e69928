#ifndef continua_materials_strain_law_h
#define continua_materials_strain_law_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Continua
{
/// The elastic deformation at a point. Gradients are always 3x3 (plane strain: F_33 = 1;
/// axisymmetry: F_33 = 1 + d_R/R). `Number`: double, or several points at once.
template <typename Number>
struct PointStrainOf
{
  dealii::Tensor<2, 3, Number> gradient; ///< F [1]
  Number determinant = 1.;               ///< J = det F [1], positive
  /// Unit directions in the stress-free state.
  std::vector<dealii::Tensor<1, 3, Number>> fibres = {};
};
using PointStrain = PointStrainOf<double>;

/**
 * A hyperelastic law at a point: stress and tangent from the deformation gradient. tau is the
 * deviator of the Kirchhoff stress (J sigma); the pressure is an unknown of its own,
 * p = -tr(sigma)/3. No function allocates memory or changes the law, so that one law serves all
 * points. A law has the text of set_stress(), set_tangent() and set_stresses() as templates in the
 * number beside these functions, which are those of double: see SolidAtPoints.
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
  /// Shear modulus at zero strain, of the isotropic part [Pa].
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
