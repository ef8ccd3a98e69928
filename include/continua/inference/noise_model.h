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

/// The correlation time [s] of noise that a first-order low-pass filter of this bandwidth [Hz] (3
/// dB) has passed: 1/(2 pi bandwidth).
double correlation_time_of_bandwidth(double bandwidth);
} // namespace Continua

#endif
