#include <continua/materials/internal_metric.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
/// Cb A - 1: what is left of it is small where a branch has little stress.
Tensor<2, 3> metric_excess(const PointStrain &strain, const SymmetricTensor<2, 3> &metric)
{
  const double factor = 1. / std::cbrt(strain.determinant * strain.determinant);
  Tensor<2, 3> excess =
      factor * (transpose(strain.gradient) * strain.gradient) * Tensor<2, 3>(metric);
  for (unsigned int i = 0; i < 3; ++i)
    excess[i][i] -= 1.;
  return excess;
}
} // namespace

MetricWeights::MetricWeights(const double ratio)
{
  old_metric = std::exp(-ratio);
  if (ratio < 0.1)
  {
    // g - e = sum_n n/(n+1)! (-1)^(n+1) x^n and 1 - g = sum_n 1/(n+1)! (-1)^(n+1) x^n, n >= 1: the
    // differences themselves would lose digits.
    old_inverse = new_inverse = 0.;
    double term = 1.;
    for (int n = 1; n <= 10; ++n)
    {
      term *= (n == 1 ? ratio : -ratio) / (n + 1);
      old_inverse += n * term;
      new_inverse += term;
    }
  }
  else
  {
    const double mean = -std::expm1(-ratio) / ratio;
    old_inverse = mean - old_metric;
    new_inverse = 1. - mean;
  }
}

SymmetricTensor<2, 3> inverse_isochoric_metric(const PointStrain &strain)
{
  const Tensor<2, 3> inverse = invert(strain.gradient);
  return std::cbrt(strain.determinant * strain.determinant) *
         symmetrize(inverse * transpose(inverse));
}

SymmetricTensor<2, 3> kept_metric(const MetricWeights &weights,
                                  const SymmetricTensor<2, 3> &old_metric,
                                  const SymmetricTensor<2, 3> &old_inverse)
{
  return weights.old_metric * old_metric + weights.old_inverse * old_inverse;
}

SymmetricTensor<2, 3> new_metric(const MetricWeights &weights,
                                 const SymmetricTensor<2, 3> &kept,
                                 const SymmetricTensor<2, 3> &new_inverse)
{
  return kept + weights.new_inverse * new_inverse;
}

double metric_energy(const double shear_modulus,
                     const PointStrain &strain,
                     const SymmetricTensor<2, 3> &metric)
{
  // ln det A = ln det(Cb A), since det Cb = 1, and the determinant by the invariants of the excess.
  const Tensor<2, 3> excess = metric_excess(strain, metric);
  const double t = trace(excess);
  const double higher =
      0.5 * (t * t - scalar_product(excess, transpose(excess))) + determinant(excess);
  return 0.5 * shear_modulus * (t - std::log1p(t + higher));
}

double metric_dissipation(const double shear_modulus,
                          const double relaxation_time,
                          const PointStrain &strain,
                          const SymmetricTensor<2, 3> &metric)
{
  // With X = Cb A: tr(X^-1 + X - 2) = tr((X - 1) X^-1 (X - 1)).
  const Tensor<2, 3> excess = metric_excess(strain, metric);
  Tensor<2, 3> product = excess;
  for (unsigned int i = 0; i < 3; ++i)
    product[i][i] += 1.;
  return 0.5 * shear_modulus / relaxation_time * trace(excess * invert(product) * excess);
}
} // namespace Continua
