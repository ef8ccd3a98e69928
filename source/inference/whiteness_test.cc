#include <continua/inference/whiteness_test.h>

#include <continua/base/undefined.h>

#include <gsl/gsl_cdf.h>

#include <algorithm>

namespace Continua
{
std::vector<double> autocorrelation(const std::vector<double> &values, const unsigned int n_lags)
{
  std::vector<double> result(n_lags + 1, 0.);
  for (unsigned int lag = 0; lag <= n_lags; ++lag)
    for (std::size_t i = lag; i < values.size(); ++i)
      result[lag] += values[i] * values[i - lag];
  const double square = result[0];
  for (double &value : result)
    value = square > 0. ? value / square : 0.;
  return result;
}

WhitenessTest ljung_box_test(const std::vector<double> &residuals,
                             const unsigned int n_fitted,
                             const unsigned int n_lags)
{
  const unsigned int n = residuals.size();
  WhitenessTest test{undefined, undefined, n_lags, 0};
  if (n_lags == 0)
    test.n_lags = std::max(std::min(10U, n / 5), n_fitted + 3);
  if (n <= test.n_lags + 1 || test.n_lags <= n_fitted)
    return test;
  const std::vector<double> correlation = autocorrelation(residuals, test.n_lags);
  test.statistic = 0.;
  for (unsigned int lag = 1; lag <= test.n_lags; ++lag)
    test.statistic += n * (n + 2.) * correlation[lag] * correlation[lag] / (n - lag);
  test.degrees_of_freedom = test.n_lags - n_fitted;
  test.probability = gsl_cdf_chisq_Q(test.statistic, test.degrees_of_freedom);
  return test;
}
} // namespace Continua
