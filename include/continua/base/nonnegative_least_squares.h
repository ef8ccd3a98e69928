#ifndef continua_base_nonnegative_least_squares_h
#define continua_base_nonnegative_least_squares_h

#include <vector>

namespace Continua
{
/// Numbers x >= 0 that make |A x - b| least.
struct NonnegativeLeastSquares
{
  std::vector<double> values; ///< x; those that the bound holds are exactly 0
  double residual_norm = 0.;  ///< |A x - b|
};

/**
 * The x >= 0 that makes |A x - b| least, by the active set method of C. L. Lawson and R. J. Hanson
 * (Solving Least Squares Problems, 1974, chapter 23), whose inner problems have a Householder QR
 * (GSL). `columns`: those of A, each as long as b. As long as columns are nearly dependent, many x
 * fit alike: the method then returns one with few values that are not 0. Throws
 * std::invalid_argument for columns of another length, and std::runtime_error if it does not end.
 */
NonnegativeLeastSquares nonnegative_least_squares(const std::vector<std::vector<double>> &columns,
                                                  const std::vector<double> &b);
} // namespace Continua

#endif
