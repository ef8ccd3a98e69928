#ifndef continua_signal_damped_sine_fit_h
#define continua_signal_damped_sine_fit_h

#include <vector>

namespace Continua
{
/// amplitude exp(-decay_rate t) sin(2 pi frequency t + phase), t being the time of the record, not
/// of its first sample.
struct DampedSine
{
  double frequency;  ///< [Hz]
  double decay_rate; ///< d [1/s]
  double amplitude;  ///< at time 0, not negative
  double phase;      ///< [rad], between -pi and pi
};
struct DampedSineFit
{
  double offset;
  std::vector<DampedSine> components; ///< in the order of the start frequencies
  double
      residual; ///< root mean square over the amplitude of the first component at the first sample
  double
      explained; ///< 1 - (sum of squares of the residual) / (that of the record about its average)
  bool converged;
};
/**
 * Fits offset + sum_j a_j exp(-d_j t) sin(2 pi f_j t + phi_j) with as many components as
 * `start_frequencies` [Hz], so that higher modes do not spoil the first one. Each start frequency
 * is first improved by a search 15 % to either side, or half-way to the next one; then all
 * parameters are found by least squares (Levenberg-Marquardt, GSL). Long records are thinned out to
 * about 20000 samples, and to no less than 40 per period of the highest start frequency.
 *
 * `times` [s] increase and need not be uniform. Where the fit does not converge, or the record has
 * too few samples for it (less than two per parameter or two per period), `converged` is false and
 * all numbers are NaN. Throws std::invalid_argument for no or non-positive start frequencies, or as
 * many times as values not being given.
 */
DampedSineFit fit_damped_sines(const std::vector<double> &times,
                               const std::vector<double> &values,
                               const std::vector<double> &start_frequencies);
} // namespace Continua

#endif
