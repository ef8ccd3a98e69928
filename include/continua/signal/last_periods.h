#ifndef continua_signal_last_periods_h
#define continua_signal_last_periods_h

#include <vector>

namespace Continua
{
/**
 * What the last periods of a record say of an oscillation that has settled, whatever came before
 * it. The values have the unit of the record. All are NaN if the record does not end with as many
 * periods of about the same length.
 */
struct LastPeriods
{
  double start, end; ///< of these periods [s]: up-crossings of their mean
  double mean;       ///< over time
  double middle;     ///< half the sum of the largest and the smallest value
  double amplitude;  ///< half their difference
  double frequency;  ///< [Hz]
  /// What the amplitude of their last half is more than that of their first half, relative; NaN for
  /// a single period. It is small once the oscillation has settled.
  double change_of_amplitude;
};
/**
 * Looks for the last `n_periods` of a record: first in all of it, then in its last half, quarter
 * and so on, until what came before no longer hides the oscillation. A period goes from one
 * up-crossing of the mean to the next, each from 5 % of the range below it to 5 % above it. The
 * longest period may be a fifth longer than the mean one, and no more than one and a half periods
 * may follow the last crossing. Extrema are those of a parabola through three samples.
 *
 * Throws std::invalid_argument if `times` [s] and `values` are not equally long, the times do not
 * increase, or `n_periods` is zero.
 */
LastPeriods analyse_last_periods(const std::vector<double> &times,
                                 const std::vector<double> &values,
                                 unsigned int n_periods);
} // namespace Continua

#endif
