#include <continua/materials/metric_stress.h>

#include <continua/materials/isochoric_stress.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

MetricStress::MetricStress(const SymmetricTensor<2, 3> &weighted_metric) : metric(weighted_metric)
{
}

SymmetricTensor<2, 3> MetricStress::fictitious_stress(const PointStrain &strain) const
{
  return symmetrize(strain.gradient * metric * transpose(strain.gradient)) /
         std::cbrt(strain.determinant * strain.determinant);
}

void MetricStress::set_stress(const PointStrain &strain, SymmetricTensor<2, 3> &stress) const
{
  stress = deviator(fictitious_stress(strain));
}

void MetricStress::set_tangent(const PointStrain &strain,
                               SymmetricTensor<2, 3> &stress,
                               SymmetricTensor<4, 3> &tangent) const
{
  const SymmetricTensor<2, 3> fictitious = fictitious_stress(strain);
  stress = deviator(fictitious);
  tangent = isochoric_tangent(trace(fictitious), stress);
}
} // namespace Continua
