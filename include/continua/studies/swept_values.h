#ifndef continua_studies_swept_values_h
#define continua_studies_swept_values_h

#include <string>
#include <vector>

namespace Continua
{
/**
 * The values that an entry of a sweep lists, each as text for the entry, in their order. Items are
 * separated by commas outside of parentheses and quotes; an item is
 * - a value, "2 MPa" or "crank nicolson"; one with commas stands in parentheses, "(4, 2)", which
 *   are left out; quotes stay, as the entry reads them, too;
 * - a range with its ends: "1 MPa to 3 MPa in 5" is so many values at equal distances, and "1 Hz
 *   to 100 Hz in 7 logarithmic" at equal ratios. The values between the ends are in the unit of
 *   the first end and rounded to six digits, or to as many more as keep each within a hundredth of
 *   its distance from the next.
 *
 * As in other lists, a unit behind the last number holds for all numbers before it that have none.
 *
 * Throws std::invalid_argument with the problem: no value, nothing between two commas, a range that
 * ends where it begins or before, fewer than two values, ends of different dimensions or not
 * positive where the range is logarithmic, a value twice (also in two units), a number without a
 * unit among others that have one.
 */
std::vector<std::string> swept_values(const std::string &text);
} // namespace Continua

#endif
