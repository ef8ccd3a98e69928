#include <continua/frequency/damped_contour.h>

#include <continua/signal/fourier_transform.h>

#include <cmath>
#include <stdexcept>

namespace Continua
{
DampedContour::DampedContour(const double duration,
                             const std::size_t n_samples,
                             const double growth)
    : decay(std::log(growth) / duration)
{
  if (!(duration > 0.) || n_samples < 2 || !(growth >= 1.) || !std::isfinite(growth))
    throw std::invalid_argument("a damped contour has a duration, two samples and a growth of one "
                                "at least");
  for (std::size_t j = 0; j < n_samples; ++j)
    sample_times.push_back(duration * j / n_samples);
  for (std::size_t k = 0; k <= n_samples / 2; ++k)
    contour.emplace_back(decay, 2. * M_PI * k / duration);
}

std::vector<DampedContour::Complex>
DampedContour::transform(const std::vector<double> &samples) const
{
  if (samples.size() != sample_times.size())
    throw std::invalid_argument("a load has a sample for each time of the contour");
  std::vector<double> damped(samples);
  for (std::size_t j = 0; j < damped.size(); ++j)
    damped[j] *= std::exp(-decay * sample_times[j]);
  return fourier_transform(damped);
}

std::vector<double> DampedContour::history(const std::vector<Complex> &transformed) const
{
  if (transformed.size() != contour.size())
    throw std::invalid_argument("a response has a value for each point of the contour");
  std::vector<double> result = inverse_fourier_transform(transformed, sample_times.size());
  for (std::size_t j = 0; j < result.size(); ++j)
    result[j] *= std::exp(decay * sample_times[j]);
  return result;
}
} // namespace Continua
