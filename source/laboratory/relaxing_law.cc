#include <continua/laboratory/relaxing_law.h>

#include <continua/materials/internal_metric.h>
#include <continua/materials/metric_stress.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

RelaxingLaw::RelaxingLaw(const StrainLaw &law, const std::vector<Branch> &all_branches)
    : law(law), old_inverse(unit_symmetric_tensor<3>())
{
  for (const Branch &branch : all_branches)
    if (!std::isinf(branch.relaxation_time))
      branches.push_back(branch);
  metrics.assign(branches.size(), unit_symmetric_tensor<3>());
  kept_metrics = metrics;
  begin_step(0.);
}

void RelaxingLaw::begin_step(const double new_duration)
{
  duration = new_duration;
  weighted.clear();
  for (unsigned int k = 0; k < branches.size(); ++k)
  {
    const MetricWeights weights(duration / branches[k].relaxation_time);
    kept_metrics[k] = kept_metric(weights, metrics[k], old_inverse);
    weighted += branches[k].shear_modulus * kept_metrics[k];
  }
}

void RelaxingLaw::end_step(const PointStrain &strain)
{
  old_inverse = inverse_isochoric_metric(strain);
  for (unsigned int k = 0; k < branches.size(); ++k)
    metrics[k] = new_metric(MetricWeights(duration / branches[k].relaxation_time), kept_metrics[k],
                            old_inverse);
}

void RelaxingLaw::set_stress(const PointStrain &strain, SymmetricTensor<2, 3> &stress) const
{
  SymmetricTensor<2, 3> of_branches;
  law.set_stress(strain, stress);
  MetricStress(weighted).set_stress(strain, of_branches);
  stress += of_branches;
}

void RelaxingLaw::set_tangent(const PointStrain &strain,
                              SymmetricTensor<2, 3> &stress,
                              SymmetricTensor<4, 3> &tangent) const
{
  SymmetricTensor<2, 3> of_branches;
  SymmetricTensor<4, 3> tangent_of_branches;
  law.set_tangent(strain, stress, tangent);
  MetricStress(weighted).set_tangent(strain, of_branches, tangent_of_branches);
  stress += of_branches;
  tangent += tangent_of_branches;
}

double RelaxingLaw::energy(const PointStrain &strain) const
{
  double sum = law.energy(strain);
  for (unsigned int k = 0; k < branches.size(); ++k)
    sum += metric_energy(branches[k].shear_modulus, strain, metrics[k]);
  return sum;
}

double RelaxingLaw::shear_modulus() const
{
  double sum = law.shear_modulus();
  for (const Branch &branch : branches)
    sum += branch.shear_modulus;
  return sum;
}

void RelaxingLaw::set_mean_stress(const PointStrain &strain,
                                  double &mean_stress,
                                  SymmetricTensor<2, 3> &derivative) const
{
  law.set_mean_stress(strain, mean_stress, derivative);
}
} // namespace Continua
