#ifndef continua_signal_jump_h
#define continua_signal_jump_h

#include <functional>

namespace Continua
{
/**
 * Whether a function of time [s] jumps somewhere in an interval: halving it towards the larger
 * change down to a millionth, what is left of the change there exceeds 1 % of the range of the
 * values met on the way and one interval earlier and later. A steep but continuous function changes
 * by a millionth of the change over the interval and is not taken for a jump. Neither is a change
 * below 1e-12 of the largest value, which is round-off. A constant that is added to the function
 * changes nothing beside that.
 */
bool jumps_within(const std::function<double(double)> &function, double begin, double end);
} // namespace Continua

#endif
