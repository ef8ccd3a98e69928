#include "../unit_test.h"

#include <continua/inference/whitening.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace test_of_whitening
{
using namespace Continua;

namespace
{
using Rows = std::vector<std::vector<double>>;

/// Covariance of n values of an autoregressive process of order 2 with variance 1, by the equations
/// of Yule and Walker.
Rows covariance_of_order_two(const double a, const double b, const unsigned int n)
{
  std::vector<double> rho{1., a / (1. - b)};
  while (rho.size() < n)
    rho.push_back(a * rho[rho.size() - 1] + b * rho[rho.size() - 2]);
  Rows covariance(n, std::vector<double>(n));
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      covariance[i][j] = rho[i > j ? i - j : j - i];
  return covariance;
}

/// Largest entry of W C W^T - 1, W being the whitening.
double error_of_white(const Whitening &whitening, const Rows &covariance)
{
  const std::size_t n = covariance.size();
  Rows half, full;
  for (const std::vector<double> &row : covariance)
    half.push_back(whitening.apply(row)); // rows of C W^T
  double largest = 0.;
  for (std::size_t j = 0; j < n; ++j)
  {
    std::vector<double> column(n);
    for (std::size_t i = 0; i < n; ++i)
      column[i] = half[i][j];
    const std::vector<double> white = whitening.apply(column);
    for (std::size_t i = 0; i < n; ++i)
      largest = std::max(largest, std::abs(white[i] - (i == j ? 1. : 0.)));
  }
  return largest;
}

void test_order_one()
{
  NoiseModel noise;
  noise.standard_deviation = 2.;
  noise.autoregressive = {0.6};
  const Whitening whitening(noise, 0.01);
  const std::vector<double> white = whitening.apply({1., 3., -2.});
  check::relative("first row by the stationary start", white[0], 0.5, 1e-15);
  check::relative("second row", white[1], (3. - 0.6) / (2. * 0.8), 1e-15);
  check::relative("third row", white[2], (-2. - 1.8) / (2. * 0.8), 1e-15);
  check::relative("determinant", whitening.log_determinant(5),
                  5. * std::log(4.) + 4. * std::log(0.64), 1e-14);
  NoiseModel relaxing;
  relaxing.standard_deviation = 2.;
  relaxing.correlation_time = -0.01 / std::log(0.6);
  check::absolute("correlation time", Whitening(relaxing, 0.01).apply({1., 3., -2.})[2], white[2],
                  1e-14);
  check::relative("coefficient", relaxing.coefficients(0.02)[0], 0.36, 1e-14);
  check::relative("bandwidth", correlation_time_of_bandwidth(100.), 1.591549430918953e-3, 1e-14);
}
} // namespace

UNIT_TEST(whitening)
{
  test_order_one();
  NoiseModel noise;
  noise.standard_deviation = 1.;
  noise.autoregressive = {1.2, -0.6};
  check::absolute("order 2",
                  error_of_white(Whitening(noise, 1.), covariance_of_order_two(1.2, -0.6, 7)), 0.,
                  1e-13);
  noise.autoregressive = {0.2, 0.5};
  check::absolute("order 2, positive",
                  error_of_white(Whitening(noise, 1.), covariance_of_order_two(0.2, 0.5, 7)), 0.,
                  1e-13);
  check::equal("words", noise.description(), "autoregressive of order 2");
  const std::vector<double> values{1., -2., 3., 0.5, 7.};
  const Whitening whitening(noise, 1.);
  const std::vector<double> back = whitening.undo(whitening.apply(values));
  double largest = 0.;
  for (std::size_t i = 0; i < values.size(); ++i)
    largest = std::max(largest, std::abs(back[i] - values[i]));
  check::absolute("undone", largest, 0., 1e-14);
  // v (1 - b) = variance (1 + b) ((1 - b)^2 - a^2)
  check::relative("innovations", whitening.innovation_deviation(),
                  std::sqrt(1.5 / 0.5 * (0.25 - 0.04)), 1e-14);
  noise.autoregressive = {1.2, -0.1};
  check::throws<std::invalid_argument>(
      "not stationary", [&]() { Whitening(noise, 1.); }, "not stationary");
  noise.autoregressive = {0.5};
  check::throws<std::invalid_argument>(
      "without order", [&]() { Whitening(noise, 0.); }, "needs values in time");
  noise.autoregressive.clear();
  check::relative("white without order", Whitening(noise, 0.).apply({3.})[0], 3., 0.);
  noise.standard_deviation = 0.;
  check::throws<std::invalid_argument>(
      "no noise", [&]() { Whitening(noise, 1.); }, "positive");
}
} // namespace test_of_whitening
