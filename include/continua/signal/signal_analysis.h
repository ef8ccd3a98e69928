#ifndef continua_signal_signal_analysis_h
#define continua_signal_signal_analysis_h

#include <vector>

namespace Continua
{
/**
 * What a probe's history says of an oscillation. Samples at increasing, not necessarily uniform times. Values that
 * cannot be had (no oscillation, too few samples) are NaN, never a guess.
 */
struct SignalAnalysis
{
  double maximum, minimum; ///< by a parabola through three samples
  double time_of_maximum, time_of_minimum; ///< [s]
  double first_maximum, time_of_first_maximum; ///< the first interior local maximum of more than 5 % of the range
  double mean; ///< over whole periods where there are any (between the first and the last crossing of the mean in one direction), else over all
  double root_mean_square;
  double frequency_zero_crossings; ///< [Hz] from the up-crossings of the mean
  double frequency_fit, decay_per_oscillation_fit; ///< of a damped sine (Levenberg-Marquardt, GSL): ratio of successive maxima about the mean
  double amplitude_fit, offset_fit, phase_fit;
  double fit_residual; ///< root mean square of the residual over the amplitude
};
SignalAnalysis analyse_signal(const std::vector<double> &times, const std::vector<double> &values);

/**
 * Fits offset + sum_j a_j exp(-d_j t) sin(2 pi f_j t + phi_j) with as many components as `start_frequencies`, so that higher
 * modes do not spoil the first one.
 */
struct DampedSine
{
  double frequency; ///< [Hz]
  double decay_rate; ///< d [1/s]
  double amplitude; ///< at time 0
  double phase; ///< [rad]
};
struct DampedSineFit
{
  double offset;
  std::vector<DampedSine> components;
  double residual; ///< root mean square over the first amplitude
  bool converged;
};
DampedSineFit fit_damped_sines(const std::vector<double> &times,
                               const std::vector<double> &values,
                               const std::vector<double> &start_frequencies);
} // namespace Continua

#endif
