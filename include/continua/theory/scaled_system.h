#ifndef continua_theory_scaled_system_h
#define continua_theory_scaled_system_h

#include <complex>
#include <cstddef>
#include <vector>

namespace Continua
{
/// A small dense complex matrix, row by row.
struct ComplexMatrix
{
  using Complex = std::complex<double>;

  ComplexMatrix(const unsigned int n_rows, const unsigned int n_columns)
      : n_rows(n_rows), n_columns(n_columns), entries(static_cast<std::size_t>(n_rows) * n_columns)
  {
  }
  Complex &operator()(const unsigned int i, const unsigned int j)
  {
    return entries[i * n_columns + j];
  }
  const Complex &operator()(const unsigned int i, const unsigned int j) const
  {
    return entries[i * n_columns + j];
  }
  unsigned int n_rows, n_columns;
  std::vector<Complex> entries;
};

/// The solution of matrix x = right for each column of `right`, found after scaling rows and
/// columns to size one: pressures, displacements and moments stand side by side.
ComplexMatrix solve_scaled(ComplexMatrix matrix, ComplexMatrix right);
} // namespace Continua

#endif
