#include <continua/network/shooting.h>

#include <cmath>

namespace Continua
{
namespace
{
constexpr unsigned int most_products = 30;
/// Of the residual of the linear equations, over that of the state.
constexpr double linear_tolerance = 0.02;
/// Of a difference, over the residual of the state: of its own size, so that the noise of the steps
/// in time is small against it.
constexpr double difference_share = 0.1;

double dot(const std::vector<double> &a, const std::vector<double> &b)
{
  double sum = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

/// The least squares of a Hessenberg matrix (by columns) and `right` in its first row, by Givens's
/// rotations.
class LeastSquares
{
public:
  explicit LeastSquares(const double right) : rights({right}) {}

  /// Takes a column; returns the norm of the residual.
  double add(std::vector<double> column)
  {
    for (std::size_t i = 0; i < cosines.size(); ++i)
    {
      const double a = column[i], b = column[i + 1];
      column[i] = cosines[i] * a + sines[i] * b;
      column[i + 1] = cosines[i] * b - sines[i] * a;
    }
    const std::size_t last = cosines.size();
    const double length = std::hypot(column[last], column[last + 1]);
    cosines.push_back(length > 0. ? column[last] / length : 1.);
    sines.push_back(length > 0. ? column[last + 1] / length : 0.);
    column[last] = length;
    rights.push_back(-sines.back() * rights[last]);
    rights[last] *= cosines.back();
    columns.push_back(column);
    return std::abs(rights.back());
  }
  std::vector<double> solution() const
  {
    std::vector<double> result(columns.size());
    for (std::size_t i = columns.size(); i-- > 0;)
    {
      double sum = rights[i];
      for (std::size_t j = i + 1; j < columns.size(); ++j)
        sum -= columns[j][i] * result[j];
      result[i] = columns[i][i] != 0. ? sum / columns[i][i] : 0.;
    }
    return result;
  }

private:
  std::vector<std::vector<double>> columns;
  std::vector<double> cosines, sines, rights;
};
} // namespace

std::vector<double> Shooting::scaled_difference(const std::vector<double> &a,
                                                const std::vector<double> &b) const
{
  std::vector<double> result(scales.size(), 0.);
  for (std::size_t i = 0; i < scales.size(); ++i)
    if (scales[i] > 0.)
      result[i] = (a[i] - b[i]) / scales[i];
  return result;
}

std::vector<double> Shooting::next(const std::vector<double> &x,
                                   const std::vector<double> &after,
                                   const Period &period,
                                   unsigned int &n_periods) const
{
  // (1 - dP/dx) change = P(x) - x.
  std::vector<double> residual = scaled_difference(after, x);
  const double norm = std::sqrt(dot(residual, residual));
  if (norm == 0.)
    return x;
  for (double &value : residual)
    value /= norm;
  std::vector<std::vector<double>> basis = {residual};
  LeastSquares problem(norm);
  const double distance = difference_share * norm;
  while (basis.size() <= most_products)
  {
    std::vector<double> shifted = x;
    for (std::size_t i = 0; i < scales.size(); ++i)
      shifted[i] += distance * scales[i] * basis.back()[i];
    ++n_periods;
    std::vector<double> product = scaled_difference(after, period(shifted)), column;
    for (std::size_t i = 0; i < product.size(); ++i)
      product[i] = basis.back()[i] + product[i] / distance;
    for (const std::vector<double> &vector : basis)
    {
      column.push_back(dot(vector, product));
      for (std::size_t i = 0; i < product.size(); ++i)
        product[i] -= column.back() * vector[i];
    }
    column.push_back(std::sqrt(dot(product, product)));
    const double length = column.back();
    if (problem.add(column) <= linear_tolerance * norm || !(length > 1e-12))
      break;
    for (double &value : product)
      value /= length;
    basis.push_back(product);
  }
  const std::vector<double> weights = problem.solution();
  std::vector<double> result = x;
  for (std::size_t k = 0; k < weights.size(); ++k)
    for (std::size_t i = 0; i < scales.size(); ++i)
      result[i] += weights[k] * scales[i] * basis[k][i];
  return result;
}
} // namespace Continua
