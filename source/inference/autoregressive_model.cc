#include <continua/inference/autoregressive_model.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>

namespace Continua
{
namespace
{
/// Burg's recursion, one order after another.
class BurgRecursion
{
public:
  BurgRecursion(const std::vector<double> &values, const bool with_mean)
      : forward(values), variance(0.)
  {
    double mean = 0.;
    if (with_mean)
      for (const double value : values)
        mean += value / values.size();
    for (double &value : forward)
    {
      value -= mean;
      variance += value * value / values.size();
    }
    backward = forward;
    if (!(variance > 0.) || !std::isfinite(variance))
      throw std::invalid_argument("an autoregressive model needs values that differ");
  }

  void raise_order()
  {
    const std::size_t m = coefficients.size() + 1;
    double numerator = 0.;
    double denominator = 0.;
    for (std::size_t t = m; t < forward.size(); ++t)
    {
      numerator += 2. * forward[t] * backward[t - 1];
      denominator += forward[t] * forward[t] + backward[t - 1] * backward[t - 1];
    }
    const double reflection = denominator > 0. ? numerator / denominator : 0.;
    std::vector<double> next(m, reflection);
    for (std::size_t j = 0; j + 1 < m; ++j)
      next[j] = coefficients[j] - reflection * coefficients[m - 2 - j];
    coefficients = next;
    for (std::size_t t = forward.size() - 1; t >= m; --t)
    {
      const double old = forward[t];
      forward[t] = old - reflection * backward[t - 1];
      backward[t] = backward[t - 1] - reflection * old;
    }
    variance *= 1. - reflection * reflection;
  }

  std::vector<double> coefficients;

private:
  std::vector<double> forward, backward; ///< errors of prediction

public:
  double variance; ///< of the innovations
};

double criterion_value(const OrderCriterion criterion,
                       const double n,
                       const double order,
                       const double variance)
{
  if (criterion == OrderCriterion::bayesian)
    return n * std::log(variance) + (order + 1.) * std::log(n);
  return n * std::log(variance) + 2. * (order + 1.) * n / (n - order - 2.);
}
} // namespace

double AutoregressiveModel::largest_spectral_ratio() const
{
  const double gain = std::pow(innovation_deviation / standard_deviation, 2);
  const unsigned int n_frequencies = 4096;
  double largest = 1.;
  for (unsigned int k = 0; k <= n_frequencies; ++k)
  {
    std::complex<double> denominator = 1.;
    for (std::size_t j = 0; j < coefficients.size(); ++j)
      denominator -= coefficients[j] * std::polar(1., -M_PI * k * (j + 1.) / n_frequencies);
    largest = std::max(largest, gain / std::norm(denominator));
  }
  return largest;
}

AutoregressiveModel fit_autoregressive_model(const std::vector<double> &values,
                                             const unsigned int order,
                                             const bool with_mean)
{
  if (values.size() < order + 2)
    throw std::invalid_argument("an autoregressive model of order " + std::to_string(order) +
                                " needs more than " + std::to_string(order + 1) + " values");
  BurgRecursion burg(values, with_mean);
  const double deviation = std::sqrt(burg.variance);
  for (unsigned int m = 0; m < order; ++m)
    burg.raise_order();
  return {burg.coefficients, std::sqrt(burg.variance), deviation};
}

AutoregressiveModel fit_autoregressive_model_of_best_order(const std::vector<double> &values,
                                                           const OrderCriterion criterion,
                                                           const bool with_mean,
                                                           const unsigned int largest_order)
{
  const double n = values.size();
  unsigned int largest = largest_order;
  if (largest == 0)
    largest = static_cast<unsigned int>(std::min(10. * std::log10(std::max(n, 1.)), 0.25 * n));
  if (n < 4.)
    largest = 0;
  BurgRecursion burg(values, with_mean);
  unsigned int best_order = 0;
  double least = std::numeric_limits<double>::infinity();
  for (unsigned int order = 0; order <= largest && order + 2 < n; ++order)
  {
    if (order > 0)
      burg.raise_order();
    if (!(burg.variance > 0.))
      break;
    const double value = criterion_value(criterion, n, order, burg.variance);
    if (value < least)
    {
      least = value;
      best_order = order;
    }
  }
  return fit_autoregressive_model(values, best_order, with_mean);
}
} // namespace Continua
