#include <continua/inference/whitening.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
Whitening::Whitening(const NoiseModel &noise, const double interval)
{
  if (!(noise.standard_deviation > 0.) || !std::isfinite(noise.standard_deviation))
    throw std::invalid_argument("noise needs a standard deviation that is positive");
  if (!noise.is_white() && !(interval > 0.))
    throw std::invalid_argument("noise that is correlated in time needs values in time");
  std::vector<double> coefficients = noise.coefficients(interval);
  const std::size_t order = coefficients.size();
  // Levinson's recursion backwards: the last coefficient of order m is its coefficient of
  // reflection, by which the variance of prediction falls from order m - 1 to m.
  predictors.resize(order + 1);
  std::vector<double> reflections(order + 1, 0.);
  for (std::size_t m = order; m > 0; --m)
  {
    predictors[m] = coefficients;
    const double reflection = coefficients[m - 1];
    if (!(std::abs(reflection) < 1.))
      throw std::invalid_argument(
          "the autoregressive coefficients of the noise are not stationary");
    reflections[m] = reflection;
    std::vector<double> lower(m - 1);
    for (std::size_t j = 0; j + 1 < m; ++j)
      lower[j] =
          (coefficients[j] + reflection * coefficients[m - 2 - j]) / (1. - reflection * reflection);
    coefficients = lower;
  }
  double variance = noise.standard_deviation * noise.standard_deviation;
  for (std::size_t m = 0; m <= order; ++m)
  {
    variance *= 1. - reflections[m] * reflections[m];
    deviations.push_back(std::sqrt(variance));
  }
}

std::vector<double> Whitening::apply(const std::vector<double> &values) const
{
  const std::size_t order = predictors.size() - 1;
  std::vector<double> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const std::size_t m = std::min(i, order);
    double innovation = values[i];
    for (std::size_t j = 0; j < m; ++j)
      innovation -= predictors[m][j] * values[i - 1 - j];
    result[i] = innovation / deviations[m];
  }
  return result;
}

std::vector<double> Whitening::undo(const std::vector<double> &white) const
{
  const std::size_t order = predictors.size() - 1;
  std::vector<double> values(white.size());
  for (std::size_t i = 0; i < white.size(); ++i)
  {
    const std::size_t m = std::min(i, order);
    values[i] = white[i] * deviations[m];
    for (std::size_t j = 0; j < m; ++j)
      values[i] += predictors[m][j] * values[i - 1 - j];
  }
  return values;
}

double Whitening::log_determinant(const unsigned int n) const
{
  double sum = 0.;
  for (std::size_t i = 0; i < n; ++i)
    sum += 2. * std::log(deviations[std::min(i, deviations.size() - 1)]);
  return sum;
}
} // namespace Continua
