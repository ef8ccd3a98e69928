#include <continua/inference/noise_model.h>

#include <continua/base/six_digits.h>

#include <cmath>

namespace Continua
{
std::vector<double> NoiseModel::coefficients(const double interval) const
{
  if (!autoregressive.empty() || !(correlation_time > 0.))
    return autoregressive;
  return {std::exp(-interval / correlation_time)};
}

std::string NoiseModel::description() const
{
  if (!autoregressive.empty())
    return "autoregressive of order " + std::to_string(autoregressive.size());
  if (correlation_time > 0.)
    return "correlation time " + six_digits(correlation_time) + " s";
  return "white";
}

double correlation_time_of_bandwidth(const double bandwidth)
{
  return 1. / (2. * M_PI * bandwidth);
}
} // namespace Continua
