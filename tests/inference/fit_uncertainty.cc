#include "../unit_test.h"
#include "function_model.h"
#include "random_noise.h"
#include "records.h"

#include <continua/inference/least_squares_fit.h>

#include <cmath>
#include <numeric>

namespace test_of_fit_uncertainty
{
using namespace Continua;

namespace
{
using Values = std::vector<double>;

FunctionModel constant(const std::size_t n)
{
  return FunctionModel([n](const Values &set) -> Values { return Values(n, set[0]); });
}

FitOptions with(const CorrelatedNoise treatment)
{
  FitOptions options;
  options.correlated_noise = treatment;
  options.tolerance = 1e-9;
  return options;
}

/// The mean of autoregressive noise of order 1 by generalised least squares: its variance is
/// s^2 (1 + phi)/(n - (n - 2) phi), from the inverse of the covariance, which has three diagonals.
void test_mean_of_order_one()
{
  const double phi = 0.8;
  const std::size_t n = 30;
  Values values = RandomNoise(3).autoregressive({phi}, n);
  DataRecord record = uniform_record("y", 0.01, values, 2.);
  record.noise.autoregressive = {phi};
  FunctionModel model = constant(n);
  const FitResult result =
      LeastSquaresFit({parameter_of("mean", 1.)}, {record}, model, with(CorrelatedNoise::as_given))
          .solve();
  const double inner = std::accumulate(values.begin() + 1, values.end() - 1, 0.);
  check::relative("mean", result.estimates[0],
                  (values.front() + values.back() + (1. - phi) * inner) / (n - (n - 2.) * phi),
                  1e-8);
  check::relative("its error", result.standard_errors[0],
                  2. * std::sqrt((1. + phi) / (n - (n - 2.) * phi)), 1e-8);
  check::equal("treatment", result.records[0].treatment, "autoregressive of order 1");
}

/// The mean of correlated noise that was given as white.
void test_sandwich()
{
  const std::size_t n = 400;
  const Values noise = RandomNoise(4).autoregressive({0.7}, n);
  FunctionModel model = constant(n);
  const DataRecord record = uniform_record("y", 0.01, noise, 1.);
  const FitResult result =
      LeastSquaresFit({parameter_of("mean", 1.)}, {record}, model, with(CorrelatedNoise::sandwich))
          .solve();
  // Newey and West of a mean: sum of autocovariances with Bartlett's weights, times n/(n - 1).
  const Values &e = result.records[0].residuals;
  const auto covariance = [&](const std::size_t lag)
  {
    return std::inner_product(e.begin() + static_cast<std::ptrdiff_t>(lag), e.end(), e.begin(), 0.);
  };
  const double r = covariance(1) / covariance(0);
  const double alpha = 4. * r * r / std::pow(1. - r * r, 2);
  const double n_lags = std::ceil(1.1447 * std::cbrt(alpha * n));
  double sum = covariance(0);
  for (unsigned int lag = 1; lag <= n_lags; ++lag)
    sum += 2. * (1. - lag / (n_lags + 1.)) * covariance(lag);
  check::relative("Newey and West", result.standard_errors[0], std::sqrt(sum * n / (n - 1.)) / n,
                  1e-8);
  check::equal("treatment by a sandwich", result.records[0].treatment,
               "sandwich over " + std::to_string(static_cast<int>(n_lags)) + " values");

  // The mean of such noise has the variance s^2 (1 + phi)/(1 - phi)/n with s^2 = 1/(1 - phi^2).
  const double truth = std::sqrt(1. / 0.51 * 1.7 / 0.3 / n);
  check::relative("near the truth", result.standard_errors[0], truth, 0.25);
  const FitResult generalised =
      LeastSquaresFit({parameter_of("mean", 1.)}, {uniform_record("y", 0.01, noise, undefined)},
                      model, with(CorrelatedNoise::autoregressive))
          .solve();
  check::relative("generalised least squares", generalised.standard_errors[0], truth, 0.25);
  check::is_true("order", generalised.records[0].n_fitted_coefficients >= 1 &&
                              generalised.records[0].whiteness.probability > 0.01);
  const FitResult enlarged =
      LeastSquaresFit({parameter_of("mean", 1.)}, {uniform_record("y", 0.01, noise, undefined)},
                      model, with(CorrelatedNoise::enlarged))
          .solve();
  check::relative("enlarged", enlarged.standard_errors[0], truth, 0.25);
  check::is_true("treatment by enlarging",
                 check::matches(enlarged.records[0].treatment, "^enlarged by 2"));
  const FitResult plain =
      LeastSquaresFit({parameter_of("mean", 1.)}, {record}, model, with(CorrelatedNoise::as_given))
          .solve();
  check::is_true(
      "nothing is done, and that is said",
      plain.standard_errors[0] < 0.5 * truth &&
          check::matches(plain.notes.front(), "'y' are correlated .*standard errors are wrong"));
}

/// A mean of which values that alternate see nothing: enlarging is too much by far, and said to be
/// so.
void test_conservative()
{
  const std::size_t n = 400;
  const Values values = RandomNoise(5).autoregressive({0.7}, n);
  FunctionModel model(
      [](const Values &set) -> Values
      {
        Values values(n, set[0]);
        for (std::size_t i = 1; i < n; i += 2)
          values[i] = -set[0];
        return values;
      });
  const double truth = std::sqrt(1. / 0.51 * 0.3 / 1.7 / n);
  const FitResult generalised = LeastSquaresFit({parameter_of("amplitude", 1.)},
                                                {uniform_record("y", 0.01, values, undefined)},
                                                model, with(CorrelatedNoise::autoregressive))
                                    .solve();
  check::relative("alternating, generalised", generalised.standard_errors[0], truth, 0.25);
  const FitResult enlarged = LeastSquaresFit({parameter_of("amplitude", 1.)},
                                             {uniform_record("y", 0.01, values, undefined)}, model,
                                             with(CorrelatedNoise::enlarged))
                                 .solve();
  check::is_true("alternating, enlarged", enlarged.standard_errors[0] > 3. * truth);
}
} // namespace

UNIT_TEST(fit_uncertainty)
{
  test_mean_of_order_one();
  test_sandwich();
  test_conservative();
}
} // namespace test_of_fit_uncertainty
