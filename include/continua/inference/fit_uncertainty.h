#ifndef continua_inference_fit_uncertainty_h
#define continua_inference_fit_uncertainty_h

#include <continua/inference/bounded_minimiser.h>
#include <continua/inference/fit_result.h>

#include <vector>

namespace Continua
{
/**
 * Fills in standard errors, covariance, correlation, intervals, whiteness and flat directions of a
 * result whose estimates, records (residuals, noise) and Jacobian are known.
 * Covariance (J^T J)^-1 of whitened rows; by Newey and West (Econometrica 55, 1987, 703) where
 * residuals are correlated and `options` say so, with Bartlett weights up to the lag of Andrews
 * (Econometrica 59, 1991, 817); or enlarged. `is_ordered`: records whose values follow each other
 * in time.
 */
void set_uncertainty(FitResult &result,
                     const std::vector<FitParameter> &parameters,
                     const WeightedResiduals &residuals,
                     const BoundedMinimiser::Minimum &minimum,
                     const std::vector<bool> &is_ordered,
                     const FitOptions &options);
} // namespace Continua

#endif
