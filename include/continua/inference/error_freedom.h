#ifndef continua_inference_error_freedom_h
#define continua_inference_error_freedom_h

#include <continua/inference/data_record.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Continua
{
/// What the residuals of a record had to tell of its noise.
struct EstimatedNoise
{
  bool deviation;              ///< its standard deviation
  unsigned int n_coefficients; ///< autoregressive coefficients
};

/**
 * Degrees of freedom [1] of the standard error of each free parameter, for Student's distribution,
 * by Satterthwaite's rule (Biometrics Bulletin 2, 1946, 110; for models like these Fai and
 * Cornelius, J. Stat. Comput. Simul. 54, 1996, 363): 2 over the variance of the logarithm of the
 * error's square. This variance follows from those of what was estimated of the noise: 2/(values
 * less those that the parameters took) for the logarithm of the variance of the innovations of a
 * record, and (innovations' variance) Gamma^-1/n for its coefficients (Brockwell and Davis
 * 1991, 8.1). One record of white noise gives n - p, two give Welch's rule; infinite if nothing was
 * estimated.
 *
 * `records` with the noise of the fit; `columns`: of the free parameters, whitened, with the rows
 * of priors; `covariance` of the coordinates.
 */
std::vector<double> degrees_of_freedom_of_errors(const std::vector<DataRecord> &records,
                                                 const std::vector<EstimatedNoise> &estimated,
                                                 const std::vector<std::vector<double>> &columns,
                                                 const dealii::FullMatrix<double> &covariance);
} // namespace Continua

#endif
