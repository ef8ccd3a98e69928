#ifndef continua_inference_noise_model_h
#define continua_inference_noise_model_h

#include <continua/base/undefined.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * Stationary Gaussian noise of a record: white, autoregressive of order p
 *
 *   e_i = phi_1 e_(i-1) + ... + phi_p e_(i-p) + innovation,
 *
 * or an Ornstein-Uhlenbeck process whose correlation falls as exp(-|t|/correlation time), which is
 * the order 1 with phi = exp(-interval/correlation time). Sampling such noise faster does not gain
 * without bound.
 */
struct NoiseModel
{
  /// [unit of the record] of the noise itself, not of its innovations. NaN: unknown, to be
  /// estimated from the residuals.
  double standard_deviation = undefined;
  std::vector<double> autoregressive; ///< phi [1]; empty: white, or by the correlation time
  double correlation_time = 0.;       ///< [s]; 0: white, or by the coefficients

  bool standard_deviation_is_known() const { return standard_deviation == standard_deviation; }
  bool is_white() const { return autoregressive.empty() && correlation_time <= 0.; }
  /// phi_1 ... phi_p [1] for values that stand `interval` [s] apart; empty if white.
  std::vector<double> coefficients(double interval) const;
  /// "white", "autoregressive of order 3", "correlation time 0.01 s".
  std::string description() const;
};

/// The correlation time [s] of noise that a first-order low-pass filter of this bandwidth [Hz] (3 dB)
/// has passed: 1/(2 pi bandwidth).
double correlation_time_of_bandwidth(double bandwidth);

/**
 * Turns values with noise of one model into values with white noise of standard deviation 1: L^-1 v
 * with the Cholesky factor L of the noise's covariance. Row i subtracts the best prediction from the
 * min(i, p) values before it and divides by the root of the variance of this prediction. The
 * predictors of the lower orders follow by Levinson's recursion backwards (Brockwell and Davis, Time
 * Series: Theory and Methods, 2nd ed. 1991, 5.2): the first p rows are exact, too.
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
  /// Logarithm of the determinant of the covariance of n values, by L: sum of 2 ln L_ii.
  double log_determinant(unsigned int n) const;

private:
  std::vector<std::vector<double>> predictors; ///< [m]: coefficients of order m
  std::vector<double> deviations;              ///< [m]: root of the variance of prediction [unit]
};
} // namespace Continua

#endif
