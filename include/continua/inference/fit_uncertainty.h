#ifndef continua_inference_fit_uncertainty_h
#define continua_inference_fit_uncertainty_h

#include <continua/inference/bounded_minimiser.h>
#include <continua/inference/error_freedom.h>
#include <continua/inference/fit_result.h>

#include <vector>

namespace Continua
{
/**
 * Fills in standard errors, covariance, correlation, intervals, whiteness and flat directions of a
 * result whose estimates, records (residuals, noise) and Jacobian are known.
 * Covariance (J^T J)^-1 of whitened rows; by Newey and West (Econometrica 55, 1987, 703) where
 * residuals are correlated and `options` say so, with Bartlett weights up to the lag of Andrews
 * (Econometrica 59, 1991, 817); or enlarged. Student's intervals with the degrees of freedom of
 * error_freedom.h. `records` with the noise of the fit, and what of it was `estimated`.
 */
void set_uncertainty(FitResult &result,
                     const std::vector<FitParameter> &parameters,
                     const std::vector<DataRecord> &records,
                     const std::vector<EstimatedNoise> &estimated,
                     const BoundedMinimiser::Minimum &minimum,
                     const FitOptions &options);
} // namespace Continua

#endif
