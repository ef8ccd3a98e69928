#ifndef continua_network_limited_slopes_h
#define continua_network_limited_slopes_h

#include <vector>

namespace Continua
{
/**
 * The difference of a value over each of a row of cells, by the values of all: central where three
 * second differences are alike, that is in a smooth wave and at its crest, and by the limiter of B.
 * van Leer elsewhere.
 */
void set_limited_differences(const std::vector<double> &values, std::vector<double> &differences);
} // namespace Continua

#endif
