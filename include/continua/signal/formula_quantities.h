#ifndef continua_signal_formula_quantities_h
#define continua_signal_formula_quantities_h

#include <continua/base/units.h>

#include <string>

namespace Continua
{
/**
 * A formula whose terms have quantities as factors, "80 mmHg + 40 mmHg*sin(2*pi*t/0.8)", with each
 * of them written as a number in SI; without a quantity the formula as it is.
 *
 * Each term of the sum outside all brackets may have one quantity, of the formula's dimension, as a
 * factor and not as a divisor; if one term has, all need one, unless they have no dimension. A unit
 * in a formula has no brackets, and ends before the variables and constants x, y, z, t, e and pi.
 * Throws std::invalid_argument with the reason for other quantities.
 */
std::string formula_in_si(const std::string &formula, const Dimension &dimension);
} // namespace Continua

#endif
