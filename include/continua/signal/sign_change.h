#ifndef continua_signal_sign_change_h
#define continua_signal_sign_change_h

#include <utility>
#include <vector>

namespace Continua
{
/**
 * Where a function changes its sign: on the straight line between two successive points (position,
 * value), which may come in any order. `number` counts from 0 in the order of the position. Values
 * of 0 have no sign. Without such a change: NaN.
 */
double find_sign_change(std::vector<std::pair<double, double>> points, unsigned int number);
} // namespace Continua

#endif
