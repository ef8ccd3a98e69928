#ifndef continua_signal_signal_analysis_h
#define continua_signal_signal_analysis_h

#include <continua/signal/damped_sine_fit.h>

#include <vector>

namespace Continua
{
/**
 * What a probe's history says of an oscillation. Samples at increasing, not necessarily uniform
 * times [s]; the values have the unit of the record. What cannot be had (no oscillation, too few
 * samples, a value that is not finite) is NaN, never a guess.
 */
struct SignalAnalysis
{
  double maximum, minimum; ///< by a parabola through three samples; at the record's ends the sample
  double time_of_maximum, time_of_minimum; ///< [s]; NaN for a constant
  /// The first interior local maximum that stands out by more than 5 % of the range on both sides.
  double first_maximum, time_of_first_maximum;
  double mean; ///< over time, for whole periods (from the first to the last up-crossing of the
               ///< mean) if there are any, else all
  double root_mean_square; ///< of the values themselves (not about the mean), over the same time
  /// [Hz] from the up-crossings of the mean, each of which goes from 5 % of the range below it to 5
  /// % above.
  double frequency_zero_crossings;
  /// Of the damped sine offset + amplitude exp(-d t) sin(2 pi f t + phase) by fit_damped_sines. NaN
  /// unless the record holds a whole period of it and it explains half of the variance at least.
  double frequency_fit;             ///< [Hz]
  double decay_per_oscillation_fit; ///< exp(-d/f): the ratio of successive maxima about the offset
  double amplitude_fit, offset_fit, phase_fit; ///< amplitude and phase [rad] at time 0
  double fit_residual; ///< root mean square of the residual over the amplitude at the first sample
};
/// Throws std::invalid_argument if `times` and `values` are not equally long or the times do not
/// increase.
SignalAnalysis analyse_signal(const std::vector<double> &times, const std::vector<double> &values);
} // namespace Continua

#endif
