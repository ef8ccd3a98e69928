#include <continua/theory/scaled_system.h>

#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace Continua
{
ComplexMatrix solve_scaled(ComplexMatrix matrix, ComplexMatrix right)
{
  using Complex = ComplexMatrix::Complex;
  const unsigned int n = matrix.n_rows;
  std::vector<double> column_sizes(n, 0.);
  for (unsigned int i = 0; i < n; ++i)
  {
    double size = 0.;
    for (unsigned int j = 0; j < n; ++j)
      size = std::max(size, std::abs(matrix(i, j)));
    for (unsigned int j = 0; j < n; ++j)
      matrix(i, j) /= size;
    for (unsigned int j = 0; j < right.n_columns; ++j)
      right(i, j) /= size;
  }
  for (unsigned int j = 0; j < n; ++j)
  {
    for (unsigned int i = 0; i < n; ++i)
      column_sizes[j] = std::max(column_sizes[j], std::abs(matrix(i, j)));
    for (unsigned int i = 0; i < n; ++i)
      matrix(i, j) /= column_sizes[j];
  }
  gsl_matrix_complex_view view =
      gsl_matrix_complex_view_array(reinterpret_cast<double *>(matrix.entries.data()), n, n);
  const std::unique_ptr<gsl_permutation, decltype(&gsl_permutation_free)> permutation(
      gsl_permutation_alloc(n), &gsl_permutation_free);
  int sign = 0;
  gsl_linalg_complex_LU_decomp(&view.matrix, permutation.get(), &sign);
  std::vector<Complex> column(n);
  for (unsigned int j = 0; j < right.n_columns; ++j)
  {
    for (unsigned int i = 0; i < n; ++i)
      column[i] = right(i, j);
    gsl_vector_complex_view vector =
        gsl_vector_complex_view_array(reinterpret_cast<double *>(column.data()), n);
    gsl_linalg_complex_LU_svx(&view.matrix, permutation.get(), &vector.vector);
    for (unsigned int i = 0; i < n; ++i)
      right(i, j) = column[i] / column_sizes[i];
  }
  return right;
}
} // namespace Continua
