#ifndef continua_inference_whitening_h
#define continua_inference_whitening_h

#include <continua/inference/noise_model.h>

#include <vector>

namespace Continua
{
/**
 * Turns values with noise of one model into values with white noise of standard deviation 1: L^-1 v
 * with the Cholesky factor L of the noise's covariance. Row i subtracts the best prediction from
 * the min(i, p) values before it and divides by the root of the variance of this prediction. The
 * predictors of the lower orders follow by Levinson's recursion backwards (Brockwell and Davis,
 * Time Series: Theory and Methods, 2nd ed. 1991, 5.2): the first p rows are exact, too.
 */
class Whitening
{
public:
  /// `interval` [s] between the values; 0: the values have no order, and the noise must be white.
  /// Throws std::invalid_argument for a standard deviation that is not positive and finite,
  /// coefficients that are not stationary, and correlated noise without an interval.
  Whitening(const NoiseModel &noise, double interval);
  /// L^-1 of values [unit of the record]: residuals, or a column of a Jacobian. In units of the
  /// standard deviation [1].
  std::vector<double> apply(const std::vector<double> &values) const;
  /// L of white values [1]: what apply() was given.
  std::vector<double> undo(const std::vector<double> &white) const;
  double innovation_deviation() const { return deviations.back(); } ///< [unit of the record]
  /// Logarithm of the determinant of the covariance of n values, by L: sum of 2 ln L_ii.
  double log_determinant(unsigned int n) const;

private:
  std::vector<std::vector<double>> predictors; ///< [m]: coefficients of order m
  std::vector<double> deviations;              ///< [m]: root of the variance of prediction [unit]
};
} // namespace Continua

#endif
