#ifndef continua_base_difference_formula_h
#define continua_base_difference_formula_h

#include <functional>
#include <vector>

namespace Continua
{
/**
 * A derivative by differences: df/dx is the sum of the weights times f at the nodes. The step is a
 * thousandth of |x|. In the middle of what x may be there are four nodes, whose formula is exact
 * for polynomials of the fourth degree, and at a bound four on one side, exact for those of the
 * third. `coarser_weights` are those of the nodes next to x alone, which are exact to the second
 * degree, and at a bound to the first: the difference of both is more than the error of the first,
 * but for round-off, of which about 1e-13 of f over its logarithmic derivative is left.
 */
struct DifferenceFormula
{
  std::vector<double> nodes;
  std::vector<double> weights, coarser_weights; ///< [1/unit of x]

  /// Of a number that is not zero. `accepts`: whether x may have a value. Throws
  /// std::invalid_argument if it may have none beside it.
  static DifferenceFormula at(double x, const std::function<bool(double)> &accepts);
};

/// The weights of the derivative at 0 of the polynomial through values at these different places.
std::vector<double> derivative_weights(const std::vector<double> &places);
} // namespace Continua

#endif
