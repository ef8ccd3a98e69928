#ifndef continua_inference_least_squares_factor_h
#define continua_inference_least_squares_factor_h

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Continua
{
/**
 * Singular values of a matrix J with few columns, each column divided by its length first: J = U S
 * V^T C. What is below 1e-10 of the largest singular value is taken for zero.
 */
class LeastSquaresFactor
{
public:
  /// Columns of the same length, which is at least their number.
  explicit LeastSquaresFactor(const std::vector<std::vector<double>> &columns);
  /// (J^T J)^-1: infinite for a column with a part in a direction that J does not see.
  dealii::FullMatrix<double> inverse_of_normal_matrix() const;
  /// The shortest (in lengths of columns) x with the least |J x - right_side|.
  std::vector<double> solve(const std::vector<double> &right_side) const;
  /// Length of the part of a vector in the range of J.
  double length_in_range(const std::vector<double> &vector) const;
  /// Diagonal of J (J^T J)^-1 J^T [1].
  std::vector<double> leverages() const;
  /// ln det J^T J; minus infinity if J does not see a direction.
  double log_determinant() const;
  /// Columns of as many rows as the rank with the same J^T J.
  std::vector<std::vector<double>> short_columns() const;
  /// Columns of length 1, at right angles to each other, of which those of J are sums with the
  /// coefficients short_columns().
  const std::vector<std::vector<double>> &orthonormal_columns() const { return left; }
  unsigned int rank() const { return singular_values.size(); }

private:
  std::vector<double> lengths;
  std::vector<double> singular_values;     ///< that are not zero
  std::vector<std::vector<double>> left;   ///< columns of U
  std::vector<std::vector<double>> right;  ///< columns of V
  std::vector<std::vector<double>> unseen; ///< columns of V with singular value zero
};
} // namespace Continua

#endif
