#ifndef continua_materials_metric_stress_h
#define continua_materials_metric_stress_h

#include <continua/materials/strain_law.h>

namespace Continua
{
/**
 * tau = dev(J^-2/3 F M F^T) of a symmetric M [Pa] that is constant within a step: that of Maxwell
 * branches, M = sum_k mu_k kept_metric_k (internal_metric.h). M = mu 1 is neo-Hookean.
 */
class MetricStress
{
public:
  explicit MetricStress(const dealii::SymmetricTensor<2, 3> &weighted_metric);

  /// As of StrainLaw.
  void set_stress(const PointStrain &strain, dealii::SymmetricTensor<2, 3> &stress) const;
  /// As of StrainLaw.
  void set_tangent(const PointStrain &strain,
                   dealii::SymmetricTensor<2, 3> &stress,
                   dealii::SymmetricTensor<4, 3> &tangent) const;

private:
  dealii::SymmetricTensor<2, 3> metric; ///< M [Pa]

  dealii::SymmetricTensor<2, 3> fictitious_stress(const PointStrain &strain) const;
};
} // namespace Continua

#endif
