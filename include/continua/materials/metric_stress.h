#ifndef continua_materials_metric_stress_h
#define continua_materials_metric_stress_h

#include <continua/base/deviatoric_part.h>
#include <continua/base/of_each.h>
#include <continua/materials/isochoric_stress.h>
#include <continua/materials/strain_law.h>

#include <cmath>

namespace Continua
{
/**
 * tau = dev(J^-2/3 F M F^T) of a symmetric M [Pa] that is constant within a step: that of Maxwell
 * branches, M = sum_k mu_k kept_metric_k (internal_metric.h). M = mu 1 is neo-Hookean. `Number`:
 * double, or several points at once.
 */
template <typename Number>
class MetricStressOf
{
public:
  explicit MetricStressOf(const dealii::SymmetricTensor<2, 3, Number> &weighted_metric)
      : metric(weighted_metric)
  {
  }

  /// As of StrainLaw.
  void set_stress(const PointStrainOf<Number> &strain,
                  dealii::SymmetricTensor<2, 3, Number> &stress) const
  {
    stress = deviatoric_part(fictitious_stress(strain));
  }
  /// As of StrainLaw.
  void set_tangent(const PointStrainOf<Number> &strain,
                   dealii::SymmetricTensor<2, 3, Number> &stress,
                   dealii::SymmetricTensor<4, 3, Number> &tangent) const
  {
    const dealii::SymmetricTensor<2, 3, Number> fictitious = fictitious_stress(strain);
    stress = deviatoric_part(fictitious);
    tangent = isochoric_tangent(trace(fictitious), stress);
  }

private:
  dealii::SymmetricTensor<2, 3, Number> metric; ///< M [Pa]

  dealii::SymmetricTensor<2, 3, Number> fictitious_stress(const PointStrainOf<Number> &strain) const
  {
    const dealii::Tensor<2, 3, Number> tensor(metric);
    return symmetrize(strain.gradient * tensor * transpose(strain.gradient)) /
           of_each([](const double j) { return std::cbrt(j * j); }, strain.determinant);
  }
};
using MetricStress = MetricStressOf<double>;
} // namespace Continua

#endif
