#ifndef continua_materials_saint_venant_kirchhoff_h
#define continua_materials_saint_venant_kirchhoff_h

#include <continua/base/deviatoric_part.h>
#include <continua/materials/isochoric_strain.h>
#include <continua/materials/isochoric_stress.h>
#include <continua/materials/strain_law.h>

namespace Continua
{
/**
 * Linear in Green's strain E = (F^T F - 1)/2: Kirchhoff stress T = F (lambda tr(E) 1 + 2 mu E) F^T,
 * of which tau is the deviator and tr(T)/(3 J) the mean Cauchy stress; energy
 * lambda/2 tr^2(E) + mu E : E. Under strong compression it becomes unstable: its stress vanishes at
 * F = 0.
 */
class SaintVenantKirchhoff final : public StrainLaw
{
public:
  /// mu [Pa], positive, and Lame's lambda = K - 2/3 mu [Pa], finite.
  SaintVenantKirchhoff(double shear_modulus, double lambda);

  /// As of StrainLaw.
  template <typename Number>
  void set_stress(const PointStrainOf<Number> &strain,
                  dealii::SymmetricTensor<2, 3, Number> &stress) const;
  template <typename Number>
  void set_tangent(const PointStrainOf<Number> &strain,
                   dealii::SymmetricTensor<2, 3, Number> &stress,
                   dealii::SymmetricTensor<4, 3, Number> &tangent) const;
  template <typename Number>
  void set_mean_stress(const PointStrainOf<Number> &strain,
                       Number &mean_stress,
                       dealii::SymmetricTensor<2, 3, Number> &derivative) const;
  template <typename Number>
  void set_stresses(const PointStrainOf<Number> &strain,
                    dealii::SymmetricTensor<2, 3, Number> &stress,
                    Number &mean_stress,
                    dealii::SymmetricTensor<2, 3, Number> &derivative) const;
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

  /// F F^T.
  template <typename Number>
  static dealii::SymmetricTensor<2, 3, Number> left_strain(const PointStrainOf<Number> &strain);
  /// T [Pa].
  template <typename Number>
  dealii::SymmetricTensor<2, 3, Number> whole_stress(const PointStrainOf<Number> &strain) const;
  /// tr T changes by this times e: 1 : c + 2 T, where T changes by c : e + g T + T g^T and
  /// c : e = lambda b (b : e) + 2 mu b e b.
  template <typename Number>
  dealii::SymmetricTensor<2, 3, Number>
  trace_derivative(const dealii::SymmetricTensor<2, 3, Number> &b,
                   const dealii::SymmetricTensor<2, 3, Number> &whole_stress) const;
  /// Of T at this strain.
  template <typename Number>
  void set_mean_of(const dealii::SymmetricTensor<2, 3, Number> &total,
                   const PointStrainOf<Number> &strain,
                   Number &mean_stress,
                   dealii::SymmetricTensor<2, 3, Number> &derivative) const;
};
template <typename Number>
dealii::SymmetricTensor<2, 3, Number>
SaintVenantKirchhoff::left_strain(const PointStrainOf<Number> &strain)
{
  return symmetrize(strain.gradient * transpose(strain.gradient));
}

template <typename Number>
dealii::SymmetricTensor<2, 3, Number>
SaintVenantKirchhoff::whole_stress(const PointStrainOf<Number> &strain) const
{
  const dealii::SymmetricTensor<2, 3, Number> twice = twice_green_strain(strain.gradient);
  dealii::Tensor<2, 3, Number> material(modulus * twice);
  const Number of_trace = 0.5 * lambda * trace(twice);
  for (unsigned int i = 0; i < 3; ++i)
    material[i][i] += of_trace;
  return symmetrize(strain.gradient * material * transpose(strain.gradient));
}

template <typename Number>
dealii::SymmetricTensor<2, 3, Number> SaintVenantKirchhoff::trace_derivative(
    const dealii::SymmetricTensor<2, 3, Number> &b,
    const dealii::SymmetricTensor<2, 3, Number> &whole_stress) const
{
  return lambda * trace(b) * b + 2. * modulus * square(b) + 2. * whole_stress;
}

template <typename Number>
void SaintVenantKirchhoff::set_mean_of(const dealii::SymmetricTensor<2, 3, Number> &total,
                                       const PointStrainOf<Number> &strain,
                                       Number &mean_stress,
                                       dealii::SymmetricTensor<2, 3, Number> &derivative) const
{
  mean_stress = trace(total) / (3. * strain.determinant);
  derivative = 1. / (3. * strain.determinant) * trace_derivative(left_strain(strain), total) -
               mean_stress * dealii::unit_symmetric_tensor<3, Number>();
}

template <typename Number>
void SaintVenantKirchhoff::set_stress(const PointStrainOf<Number> &strain,
                                      dealii::SymmetricTensor<2, 3, Number> &stress) const
{
  stress = deviatoric_part(whole_stress(strain));
}

template <typename Number>
void SaintVenantKirchhoff::set_stresses(const PointStrainOf<Number> &strain,
                                        dealii::SymmetricTensor<2, 3, Number> &stress,
                                        Number &mean_stress,
                                        dealii::SymmetricTensor<2, 3, Number> &derivative) const
{
  const dealii::SymmetricTensor<2, 3, Number> total = whole_stress(strain);
  stress = deviatoric_part(total);
  set_mean_of(total, strain, mean_stress, derivative);
}

template <typename Number>
void SaintVenantKirchhoff::set_mean_stress(const PointStrainOf<Number> &strain,
                                           Number &mean_stress,
                                           dealii::SymmetricTensor<2, 3, Number> &derivative) const
{
  set_mean_of(whole_stress(strain), strain, mean_stress, derivative);
}

template <typename Number>
void SaintVenantKirchhoff::set_tangent(const PointStrainOf<Number> &strain,
                                       dealii::SymmetricTensor<2, 3, Number> &stress,
                                       dealii::SymmetricTensor<4, 3, Number> &tangent) const
{
  const dealii::SymmetricTensor<2, 3, Number> b = left_strain(strain), total = whole_stress(strain),
                                              of_trace = trace_derivative(b, total);
  stress = deviatoric_part(total);
  // What the mean of T takes from g T + T g^T comes back, and the mean itself changes.
  tangent = lambda * dyadic_product(b, b) + 2. * modulus * both_sides_product(b) +
            2. / 3. * trace(total) * dealii::identity_tensor<3, Number>() -
            1. / 3. * dyadic_product(dealii::unit_symmetric_tensor<3, Number>(), of_trace);
}
} // namespace Continua

#endif
