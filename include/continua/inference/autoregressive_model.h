#ifndef continua_inference_autoregressive_model_h
#define continua_inference_autoregressive_model_h

#include <continua/inference/noise_model.h>

#include <vector>

namespace Continua
{
/// How many coefficients the noise of a record needs: the order with the least criterion.
enum class OrderCriterion
{
  corrected_akaike, ///< AICc = n ln v + 2 (p+1) n/(n-p-2), Hurvich and Tsai, Biometrika 76, 1989,
                    ///< 297
  bayesian          ///< BIC = n ln v + (p+1) ln n, Schwarz, Ann. Statist. 6, 1978, 461
};

/// An autoregressive model found in a record of noise.
struct AutoregressiveModel
{
  std::vector<double> coefficients; ///< phi [1]; empty: white
  double innovation_deviation;      ///< [unit] standard deviation of the innovations
  double standard_deviation;        ///< [unit] of the noise itself
  /// Largest spectral density over the one of white noise with the same standard deviation [1], at
  /// least 1. No weighted sum of values has a larger variance than this times its variance with
  /// white noise.
  double largest_spectral_ratio() const;
};

/**
 * Burg's method: the coefficients of reflection that give the least sum of the squared forward and
 * backward errors of prediction. The model is always stationary. (Brockwell and Davis, Introduction
 * to Time Series and Forecasting, 3rd ed. 2016, 5.1.2.) The mean of the values is taken off first
 * if `with_mean` (a record at rest whose level is unknown). Throws std::invalid_argument for fewer
 * than order + 2 values or values that are all equal.
 */
AutoregressiveModel
fit_autoregressive_model(const std::vector<double> &values, unsigned int order, bool with_mean);

/// The same with the order that has the least criterion, from 0 to `largest_order` (0: chosen,
/// 10 log10(n), and no more than n/4).
AutoregressiveModel fit_autoregressive_model_of_best_order(const std::vector<double> &values,
                                                           OrderCriterion criterion,
                                                           bool with_mean,
                                                           unsigned int largest_order = 0);
} // namespace Continua

#endif
