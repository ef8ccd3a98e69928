#include <continua/base/quiet_gsl.h>
#include <continua/signal/gsl_release.h>
#include <continua/signal/linear_recurrence.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_poly.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

namespace Continua
{
namespace
{
using Matrix = std::unique_ptr<gsl_matrix, GslRelease<gsl_matrix, gsl_matrix_free>>;
using Vector = std::unique_ptr<gsl_vector, GslRelease<gsl_vector, gsl_vector_free>>;
using Permutation =
    std::unique_ptr<gsl_permutation, GslRelease<gsl_permutation, gsl_permutation_free>>;
using Workspace =
    std::unique_ptr<gsl_poly_complex_workspace,
                    GslRelease<gsl_poly_complex_workspace, gsl_poly_complex_workspace_free>>;
} // namespace

std::vector<std::complex<double>> polynomial_roots(const std::vector<double> &coefficients)
{
  const QuietGsl quiet;
  const std::size_t n = coefficients.size();
  const Workspace workspace(gsl_poly_complex_workspace_alloc(n));
  std::vector<double> parts(2 * (n - 1));
  if (gsl_poly_complex_solve(coefficients.data(), n, workspace.get(), parts.data()) != GSL_SUCCESS)
    throw std::runtime_error("the roots of a polynomial do not converge");
  std::vector<std::complex<double>> roots;
  for (std::size_t i = 0; i + 1 < n; ++i)
    roots.emplace_back(parts[2 * i], parts[2 * i + 1]);
  std::sort(roots.begin(), roots.end(),
            [](const std::complex<double> a, const std::complex<double> b)
            { return std::abs(a) > std::abs(b); });
  // The magnitudes of a pair differ by round-off.
  for (std::size_t i = 0; i + 1 < roots.size(); ++i)
    if (roots[i].imag() < 0. &&
        std::abs(roots[i] - std::conj(roots[i + 1])) < 1e-9 * std::abs(roots[i]))
      std::swap(roots[i], roots[i + 1]);
  return roots;
}

std::vector<std::complex<double>> recurrence_factors(const std::vector<double> &sequence,
                                                     const unsigned int order)
{
  if (order == 0 || sequence.size() < 2 * static_cast<std::size_t>(order))
    throw std::invalid_argument("the sequence is shorter than twice the order");
  // sum_j c_j a_(i+j) = -a_(i+order) for as many rows as there are coefficients.
  const Matrix matrix(gsl_matrix_alloc(order, order));
  const Vector right_side(gsl_vector_alloc(order)), solution(gsl_vector_alloc(order));
  for (unsigned int i = 0; i < order; ++i)
  {
    // In a sequence that decays each row has a scale of its own.
    double scale = 0.;
    for (unsigned int j = 0; j <= order; ++j)
      scale = std::max(scale, std::abs(sequence[i + j]));
    if (scale == 0.)
      throw std::invalid_argument("the sequence has fewer numbers than the order");
    for (unsigned int j = 0; j < order; ++j)
      gsl_matrix_set(matrix.get(), i, j, sequence[i + j] / scale);
    gsl_vector_set(right_side.get(), i, -sequence[i + order] / scale);
  }
  const Permutation permutation(gsl_permutation_alloc(order));
  int sign = 0;
  gsl_linalg_LU_decomp(matrix.get(), permutation.get(), &sign);
  for (unsigned int i = 0; i < order; ++i)
    if (std::abs(gsl_matrix_get(matrix.get(), i, i)) < 1e-14)
      throw std::invalid_argument("the sequence has fewer numbers than the order");
  gsl_linalg_LU_solve(matrix.get(), permutation.get(), right_side.get(), solution.get());
  std::vector<double> coefficients(order + 1, 1.);
  for (unsigned int j = 0; j < order; ++j)
    coefficients[j] = gsl_vector_get(solution.get(), j);
  return polynomial_roots(coefficients);
}
} // namespace Continua
