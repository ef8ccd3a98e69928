#include <continua/base/nonnegative_least_squares.h>

#include <gsl/gsl_linalg.h>

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace Continua
{
namespace
{
struct FreeGslMatrix
{
  void operator()(gsl_matrix *matrix) const { gsl_matrix_free(matrix); }
};
struct FreeGslVector
{
  void operator()(gsl_vector *vector) const { gsl_vector_free(vector); }
};
using GslMatrix = std::unique_ptr<gsl_matrix, FreeGslMatrix>;
using GslVector = std::unique_ptr<gsl_vector, FreeGslVector>;

/// A with columns of length 1, and what the method knows of each of them.
class ActiveSet
{
public:
  ActiveSet(const std::vector<std::vector<double>> &columns, const std::vector<double> &b)
      : n_rows(b.size()), right_side(b), values(columns.size(), 0.), is_free(columns.size(), false)
  {
    for (const std::vector<double> &column : columns)
    {
      if (column.size() != n_rows)
        throw std::invalid_argument("a column is not as long as the right-hand side");
      double square = 0.;
      for (const double entry : column)
        square += entry * entry;
      norms.push_back(std::sqrt(square));
      unit_columns.push_back(column);
      for (double &entry : unit_columns.back())
        entry /= norms.back() > 0. ? norms.back() : 1.;
    }
  }

  void solve()
  {
    // Round-off of a gradient, of columns of length 1.
    double scale = 0.;
    for (const double entry : right_side)
      scale += entry * entry;
    const double tolerance = 10. * std::numeric_limits<double>::epsilon() * std::sqrt(scale);
    std::vector<bool> is_refused(values.size(), false);
    for (std::size_t i = 0; i < 10 * values.size() + 10; ++i)
    {
      const std::size_t next = steepest(is_refused, tolerance);
      if (next == values.size() || n_free() == n_rows)
        return;
      is_free[next] = true;
      std::vector<double> trial = of_free();
      if (!(trial[next] > 0.))
      {
        // Round-off alone made its gradient positive.
        is_free[next] = false;
        is_refused[next] = true;
        continue;
      }
      while (!take(trial))
        trial = of_free();
      is_refused.assign(values.size(), false);
    }
    throw std::runtime_error("the least squares without negative values do not end");
  }

  NonnegativeLeastSquares result() const
  {
    NonnegativeLeastSquares result;
    for (std::size_t j = 0; j < values.size(); ++j)
      result.values.push_back(is_free[j] ? values[j] / norms[j] : 0.);
    double square = 0.;
    for (const double entry : residual())
      square += entry * entry;
    result.residual_norm = std::sqrt(square);
    return result;
  }

private:
  const std::size_t n_rows;
  const std::vector<double> right_side;
  std::vector<std::vector<double>> unit_columns;
  std::vector<double> norms, values; ///< values of the unit columns
  std::vector<bool> is_free;         ///< not held at 0

  std::size_t n_free() const
  {
    std::size_t n = 0;
    for (const bool free : is_free)
      n += free ? 1 : 0;
    return n;
  }

  std::vector<double> residual() const
  {
    std::vector<double> rest = right_side;
    for (std::size_t j = 0; j < values.size(); ++j)
      if (values[j] != 0.)
        for (std::size_t i = 0; i < n_rows; ++i)
          rest[i] -= values[j] * unit_columns[j][i];
    return rest;
  }

  /// The held column along which the square falls fastest; their number if none falls.
  std::size_t steepest(const std::vector<bool> &is_refused, const double tolerance) const
  {
    const std::vector<double> rest = residual();
    std::size_t best = values.size();
    double largest = tolerance;
    for (std::size_t j = 0; j < values.size(); ++j)
    {
      if (is_free[j] || is_refused[j] || norms[j] == 0.)
        continue;
      double slope = 0.;
      for (std::size_t i = 0; i < n_rows; ++i)
        slope += unit_columns[j][i] * rest[i];
      if (slope > largest)
      {
        largest = slope;
        best = j;
      }
    }
    return best;
  }

  /// The least squares of the free columns alone, of any sign.
  std::vector<double> of_free() const
  {
    std::vector<std::size_t> free;
    for (std::size_t j = 0; j < values.size(); ++j)
      if (is_free[j])
        free.push_back(j);
    const GslMatrix matrix(gsl_matrix_alloc(n_rows, free.size()));
    const GslVector tau(gsl_vector_alloc(free.size())), solution(gsl_vector_alloc(free.size())),
        rest(gsl_vector_alloc(n_rows));
    for (std::size_t k = 0; k < free.size(); ++k)
      for (std::size_t i = 0; i < n_rows; ++i)
        gsl_matrix_set(matrix.get(), i, k, unit_columns[free[k]][i]);
    const gsl_vector_const_view b = gsl_vector_const_view_array(right_side.data(), n_rows);
    gsl_linalg_QR_decomp(matrix.get(), tau.get());
    gsl_linalg_QR_lssolve(matrix.get(), tau.get(), &b.vector, solution.get(), rest.get());
    std::vector<double> trial(values.size(), 0.);
    for (std::size_t k = 0; k < free.size(); ++k)
      trial[free[k]] = gsl_vector_get(solution.get(), k);
    return trial;
  }

  /// Goes to the trial, or towards it until a value is 0, which is held from then on; returns
  /// whether the trial was reached.
  bool take(const std::vector<double> &trial)
  {
    double share = 1.;
    std::size_t first = values.size();
    for (std::size_t j = 0; j < values.size(); ++j)
      if (is_free[j] && !(trial[j] > 0.) && values[j] / (values[j] - trial[j]) < share)
      {
        share = values[j] / (values[j] - trial[j]);
        first = j;
      }
    for (std::size_t j = 0; j < values.size(); ++j)
      if (is_free[j])
      {
        values[j] += share * (trial[j] - values[j]);
        if (j == first || (share < 1. && !(values[j] > 0.)))
        {
          values[j] = 0.;
          is_free[j] = false;
        }
      }
    return first == values.size();
  }
};
} // namespace

NonnegativeLeastSquares nonnegative_least_squares(const std::vector<std::vector<double>> &columns,
                                                  const std::vector<double> &b)
{
  ActiveSet set(columns, b);
  set.solve();
  return set.result();
}
} // namespace Continua
