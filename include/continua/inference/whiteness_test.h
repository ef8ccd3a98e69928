#ifndef continua_inference_whiteness_test_h
#define continua_inference_whiteness_test_h

#include <vector>

namespace Continua
{
/// Whether residuals are correlated.
struct WhitenessTest
{
  double statistic;   ///< Q [1]
  double probability; ///< of a Q at least as large if the residuals are white [1]; NaN: too few
  unsigned int n_lags;
  unsigned int degrees_of_freedom;
};

/// Autocorrelation of values about zero at the lags 0 ... n_lags [1].
std::vector<double> autocorrelation(const std::vector<double> &values, unsigned int n_lags);

/**
 * Ljung and Box (Biometrika 65, 1978, 297): Q = n (n+2) sum_k r_k^2/(n-k) over the lags 1 ... m is
 * chi-square with m - `n_fitted` degrees of freedom, `n_fitted` being the coefficients of an
 * autoregressive model that were found in the same record. `n_lags` 0: chosen, the smaller of 10
 * and n/5, and at least n_fitted + 3. Too few values (no more than n_lags + 1) have the probability
 * NaN.
 */
WhitenessTest ljung_box_test(const std::vector<double> &residuals,
                             unsigned int n_fitted = 0,
                             unsigned int n_lags = 0);
} // namespace Continua

#endif
