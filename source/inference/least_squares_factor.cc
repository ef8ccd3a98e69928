#include <continua/inference/least_squares_factor.h>

#include <continua/base/quiet_gsl.h>
#include <continua/signal/gsl_release.h>

#include <gsl/gsl_linalg.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <stdexcept>

namespace Continua
{
namespace
{
using FactorMatrix = std::unique_ptr<gsl_matrix, GslRelease<gsl_matrix, gsl_matrix_free>>;
using FactorVector = std::unique_ptr<gsl_vector, GslRelease<gsl_vector, gsl_vector_free>>;

double product(const std::vector<double> &a, const std::vector<double> &b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}
} // namespace

LeastSquaresFactor::LeastSquaresFactor(const std::vector<std::vector<double>> &columns)
{
  const std::size_t p = columns.size();
  if (p == 0 || columns.front().size() < p)
    throw std::invalid_argument("a least-squares problem needs columns, and as many rows");
  const std::size_t n = columns.front().size();
  const QuietGsl quiet;
  const FactorMatrix u(gsl_matrix_alloc(n, p));
  const FactorMatrix v(gsl_matrix_alloc(p, p));
  const FactorVector s(gsl_vector_alloc(p));
  for (std::size_t j = 0; j < p; ++j)
  {
    lengths.push_back(std::sqrt(product(columns[j], columns[j])));
    for (std::size_t i = 0; i < n; ++i)
      gsl_matrix_set(u.get(), i, j, lengths[j] > 0. ? columns[j][i] / lengths[j] : 0.);
  }
  if (gsl_linalg_SV_decomp_jacobi(u.get(), v.get(), s.get()) != GSL_SUCCESS)
    throw std::runtime_error("the singular values of derivatives could not be computed");
  const double largest = gsl_vector_get(s.get(), 0);
  for (std::size_t k = 0; k < p; ++k)
  {
    std::vector<double> column_of_v(p);
    for (std::size_t j = 0; j < p; ++j)
      column_of_v[j] = gsl_matrix_get(v.get(), j, k);
    if (!(gsl_vector_get(s.get(), k) > 1e-10 * largest))
    {
      unseen.push_back(column_of_v);
      continue;
    }
    singular_values.push_back(gsl_vector_get(s.get(), k));
    right.push_back(column_of_v);
    left.emplace_back(n);
    for (std::size_t i = 0; i < n; ++i)
      left.back()[i] = gsl_matrix_get(u.get(), i, k);
  }
}

dealii::FullMatrix<double> LeastSquaresFactor::inverse_of_normal_matrix() const
{
  const std::size_t p = lengths.size();
  std::vector<bool> is_seen(p, true);
  for (const std::vector<double> &direction : unseen)
    for (std::size_t j = 0; j < p; ++j)
      if (std::abs(direction[j]) > 1e-6)
        is_seen[j] = false;
  dealii::FullMatrix<double> inverse(p, p);
  for (std::size_t i = 0; i < p; ++i)
    for (std::size_t j = 0; j < p; ++j)
      if (!is_seen[i] || !is_seen[j])
        inverse(i, j) = i == j ? std::numeric_limits<double>::infinity() : 0.;
      else
        for (std::size_t k = 0; k < singular_values.size(); ++k)
          inverse(i, j) += right[k][i] * right[k][j] /
                           (singular_values[k] * singular_values[k] * lengths[i] * lengths[j]);
  return inverse;
}

std::vector<double> LeastSquaresFactor::solve(const std::vector<double> &right_side) const
{
  std::vector<double> x(lengths.size(), 0.);
  for (std::size_t k = 0; k < singular_values.size(); ++k)
  {
    const double amount = product(left[k], right_side) / singular_values[k];
    for (std::size_t j = 0; j < x.size(); ++j)
      if (lengths[j] > 0.)
        x[j] += amount * right[k][j] / lengths[j];
  }
  return x;
}

double LeastSquaresFactor::length_in_range(const std::vector<double> &vector) const
{
  double sum = 0.;
  for (const std::vector<double> &direction : left)
    sum += std::pow(product(direction, vector), 2);
  return std::sqrt(sum);
}

std::vector<double> LeastSquaresFactor::leverages() const
{
  std::vector<double> result(left.empty() ? 0 : left.front().size(), 0.);
  for (const std::vector<double> &direction : left)
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] += direction[i] * direction[i];
  return result;
}

std::vector<std::vector<double>> LeastSquaresFactor::short_columns() const
{
  std::vector<std::vector<double>> columns(lengths.size());
  for (std::size_t j = 0; j < columns.size(); ++j)
    for (std::size_t k = 0; k < singular_values.size(); ++k)
      columns[j].push_back(singular_values[k] * right[k][j] * lengths[j]);
  return columns;
}

double LeastSquaresFactor::log_determinant() const
{
  if (!unseen.empty())
    return -std::numeric_limits<double>::infinity();
  double sum = 0.;
  for (const double length : lengths)
    sum += 2. * std::log(length);
  for (const double value : singular_values)
    sum += 2. * std::log(value);
  return sum;
}
} // namespace Continua
