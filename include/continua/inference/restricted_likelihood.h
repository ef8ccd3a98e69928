#ifndef continua_inference_restricted_likelihood_h
#define continua_inference_restricted_likelihood_h

#include <continua/inference/noise_model.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Continua
{
/// What the autoregressive noise of one record is found from.
struct ResidualsOfRecord
{
  double interval;                          ///< [s]
  std::vector<double> residuals;            ///< [unit]
  std::vector<std::vector<double>> columns; ///< d prediction / d coordinate of the free parameters
  dealii::FullMatrix<double> other_information; ///< J^T W J of other records and of priors
};

/**
 * Autoregressive noise by restricted maximum likelihood (Patterson and Thompson, Biometrika 58,
 * 1971, 545): the least
 *
 *   ln det V + e^T V^-1 e + ln det(further information + J^T V^-1 J),
 *
 * V being the covariance of the noise. A fit makes residuals less correlated than the noise is; the
 * last term takes this off. Sought from `start` by the simplex of Nelder and Mead, in the inverse
 * hyperbolic tangents of the coefficients of reflection, so that the noise is always stationary.
 * The standard deviation of `start` stays as it is if `deviation_is_known`.
 */
NoiseModel restricted_likelihood_noise(const ResidualsOfRecord &record,
                                       const NoiseModel &start,
                                       bool deviation_is_known);
} // namespace Continua

#endif
