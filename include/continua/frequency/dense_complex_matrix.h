#ifndef continua_frequency_dense_complex_matrix_h
#define continua_frequency_dense_complex_matrix_h

#include <complex>
#include <cstddef>
#include <vector>

namespace Continua
{
/// A dense complex matrix, column by column as LAPACK takes it; zero at first.
class DenseComplexMatrix
{
public:
  using Complex = std::complex<double>;

  DenseComplexMatrix(std::size_t n_rows, std::size_t n_columns);
  Complex &operator()(const std::size_t row, const std::size_t column)
  {
    return entries[column * rows + row];
  }
  const Complex &operator()(const std::size_t row, const std::size_t column) const
  {
    return entries[column * rows + row];
  }
  std::size_t n_rows() const { return rows; }
  std::size_t n_columns() const { return columns; }
  Complex *data() { return entries.data(); }

private:
  std::size_t rows, columns;
  std::vector<Complex> entries;
};

/// The vector x of length one with the smallest |A x| (LAPACK's zgesvd), and that value.
struct SmallestSingularVector
{
  std::vector<std::complex<double>> vector;
  double value; ///< 0 for a matrix of fewer rows than columns
};
/// Throws RunError if LAPACK does not converge or an entry is not a finite number.
SmallestSingularVector smallest_singular_vector(DenseComplexMatrix matrix);

/// The values lambda of A x = lambda B x (LAPACK's zggev), the smallest magnitude first. Infinite
/// ones have an infinite real part. Throws RunError as above.
std::vector<std::complex<double>> generalised_eigenvalues(DenseComplexMatrix a,
                                                          DenseComplexMatrix b);

/// The x with the smallest |A x - right| (LAPACK's zgels) for a matrix of full rank that has at
/// least as many rows as columns. Throws RunError as above, and for a matrix that is singular.
std::vector<std::complex<double>> least_squares_solution(DenseComplexMatrix matrix,
                                                         std::vector<std::complex<double>> right);
} // namespace Continua

#endif
