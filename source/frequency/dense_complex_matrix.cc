#include <continua/frequency/dense_complex_matrix.h>

#include <continua/base/input_error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

extern "C"
{
  // Of LAPACK; Fortran's integers are `int` in Debian's packages.
  void zgesvd_(const char *job_u,
               const char *job_vt,
               const int *m,
               const int *n,
               std::complex<double> *a,
               const int *lda,
               double *s,
               std::complex<double> *u,
               const int *ldu,
               std::complex<double> *vt,
               const int *ldvt,
               std::complex<double> *work,
               const int *lwork,
               double *rwork,
               int *info);
  void zggev_(const char *job_vl,
              const char *job_vr,
              const int *n,
              std::complex<double> *a,
              const int *lda,
              std::complex<double> *b,
              const int *ldb,
              std::complex<double> *alpha,
              std::complex<double> *beta,
              std::complex<double> *vl,
              const int *ldvl,
              std::complex<double> *vr,
              const int *ldvr,
              std::complex<double> *work,
              const int *lwork,
              double *rwork,
              int *info);
  void zgels_(const char *transposed,
              const int *m,
              const int *n,
              const int *n_right,
              std::complex<double> *a,
              const int *lda,
              std::complex<double> *b,
              const int *ldb,
              std::complex<double> *work,
              const int *lwork,
              int *info);
}

namespace Continua
{
namespace
{
using Complex = std::complex<double>;

void expect_finite(DenseComplexMatrix &matrix)
{
  const Complex *const entries = matrix.data();
  for (std::size_t i = 0; i < matrix.n_rows() * matrix.n_columns(); ++i)
    if (!std::isfinite(entries[i].real()) || !std::isfinite(entries[i].imag()))
      throw RunError("A dense matrix of the frequency domain has an entry that is no number.");
}

/// Calls a routine of LAPACK for the length of its work space, then with this space.
template <typename Call>
void call_with_work(const std::string &name, const Call &call)
{
  Complex best = 0.;
  int length = -1, status = 0;
  call(&best, &length, &status);
  length = static_cast<int>(best.real());
  std::vector<Complex> work(std::max(length, 1));
  call(work.data(), &length, &status);
  if (status != 0)
    throw RunError("LAPACK, " + name + ": error " + std::to_string(status) + ".");
}
} // namespace

DenseComplexMatrix::DenseComplexMatrix(const std::size_t n_rows, const std::size_t n_columns)
    : rows(n_rows), columns(n_columns), entries(n_rows * n_columns)
{
}

SmallestSingularVector smallest_singular_vector(DenseComplexMatrix matrix)
{
  expect_finite(matrix);
  const int m = static_cast<int>(matrix.n_rows()), n = static_cast<int>(matrix.n_columns());
  const int n_values = std::min(m, n), one = 1;
  DenseComplexMatrix right(n, n);
  std::vector<double> values(std::max(n_values, 1)),
      real_work(std::size_t{5} * std::max(n_values, 1));
  SmallestSingularVector result{std::vector<Complex>(n), 0.};
  if (n_values == 0)
  {
    result.vector.back() = 1.;
    return result;
  }
  call_with_work("singular values",
                 [&](Complex *const work, const int *const length, int *const status)
                 {
                   zgesvd_("N", "A", &m, &n, matrix.data(), &m, values.data(), nullptr, &one,
                           right.data(), &n, work, length, real_work.data(), status);
                 });
  for (int k = 0; k < n; ++k)
    result.vector[k] = std::conj(right(n - 1, k));
  result.value = m < n ? 0. : values.back();
  return result;
}

std::vector<Complex> generalised_eigenvalues(DenseComplexMatrix a, DenseComplexMatrix b)
{
  expect_finite(a);
  expect_finite(b);
  const int n = static_cast<int>(a.n_rows()), one = 1;
  std::vector<Complex> numerators(n), denominators(n), result;
  std::vector<double> real_work(std::size_t{8} * std::max(n, 1));
  if (n == 0)
    return result;
  call_with_work("generalised eigenvalues",
                 [&](Complex *const work, const int *const length, int *const status)
                 {
                   zggev_("N", "N", &n, a.data(), &n, b.data(), &n, numerators.data(),
                          denominators.data(), nullptr, &one, nullptr, &one, work, length,
                          real_work.data(), status);
                 });
  for (int k = 0; k < n; ++k)
    result.push_back(denominators[k] == 0. ? Complex(std::numeric_limits<double>::infinity(), 0.)
                                           : numerators[k] / denominators[k]);
  std::sort(result.begin(), result.end(),
            [](const Complex &x, const Complex &y) { return std::abs(x) < std::abs(y); });
  return result;
}

std::vector<Complex> least_squares_solution(DenseComplexMatrix matrix, std::vector<Complex> right)
{
  expect_finite(matrix);
  const int m = static_cast<int>(matrix.n_rows()), n = static_cast<int>(matrix.n_columns());
  const int one = 1;
  call_with_work(
      "least squares", [&](Complex *const work, const int *const length, int *const status)
      { zgels_("N", &m, &n, &one, matrix.data(), &m, right.data(), &m, work, length, status); });
  right.resize(n);
  return right;
}
} // namespace Continua
