#ifndef continua_signal_beat_values_h
#define continua_signal_beat_values_h

#include <cstddef>
#include <vector>

namespace Continua
{
/// What a history does in one beat, in its own unit.
struct BeatValues
{
  double largest;  ///< of a pressure: systolic
  double smallest; ///< of a pressure: diastolic
  double mean;     ///< over time
  double range;    ///< largest less smallest: the pulse pressure, or the distension
  /// The largest difference from the beat before, at the same times after their starts, over the
  /// range of this beat [1]. NaN of the first beat.
  double difference;
};

/**
 * The values of the beat `number`, from 1, of a history whose samples are evenly spaced,
 * `n_intervals` of them in a beat: beat n goes from the sample (n - 1) n_intervals to the sample n
 * n_intervals, both included. Largest and smallest values are those of a parabola through three
 * samples; the mean is that of the trapezoidal rule. `times` [s] and `values` are equally long.
 * If `jumps_at_start` the loads jump as the history begins: its first sample is no part of the
 * first beat where the second one is compared with it.
 * Where the history has a value that is not a number all of the beat's are NaN.
 *
 * Throws std::invalid_argument if the history ends before the beat does.
 */
BeatValues beat_values(const std::vector<double> &times,
                       const std::vector<double> &values,
                       std::size_t n_intervals,
                       std::size_t number,
                       bool jumps_at_start = false);
} // namespace Continua

#endif
