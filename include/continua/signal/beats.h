#ifndef continua_signal_beats_h
#define continua_signal_beats_h

#include <cstddef>
#include <vector>

namespace Continua
{
/// How often a load rises and falls.
struct Beats
{
  unsigned int number = 0;
  /// The sample at which the second beat begins: the last one before its rise that is within a
  /// hundredth of the range above the lowest value between the two. The number of samples if there
  /// is no second beat.
  std::size_t second_begins = 0;
};

/**
 * Counts the beats of a load from its samples. A beat is a rise above 0.7 of the range between the
 * least and the largest sample after one below 0.3 of it (or after the first sample), so that noise
 * and a notch count for nothing. A load that does not vary has no beat.
 */
Beats find_beats(const std::vector<double> &values);
} // namespace Continua

#endif
