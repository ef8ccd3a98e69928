#include <continua/signal/energy_frequency.h>

#include <continua/signal/fourier_transform.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Continua
{
double
energy_frequency(const std::vector<double> &samples, const double interval, const double part)
{
  if (samples.size() < 2)
    return 0.;
  const auto range = std::minmax_element(samples.begin(), samples.end());
  const double largest = std::max(std::abs(*range.first), std::abs(*range.second));
  if (*range.second - *range.first <= 1e-12 * largest)
    return 0.;
  const double mean = std::accumulate(samples.begin(), samples.end(), 0.) / samples.size();
  std::vector<double> padded(next_power_of_two(8 * samples.size()), 0.);
  std::transform(samples.begin(), samples.end(), padded.begin(),
                 [mean](const double sample) { return sample - mean; });
  const std::vector<std::complex<double>> spectrum = fourier_transform(padded);
  double total = 0.;
  for (const std::complex<double> amplitude : spectrum)
    total += std::norm(amplitude);
  // Linear between the frequencies, each of which stands for a band of its own around it.
  double sum = 0., before = 0.;
  std::size_t k = 0;
  for (; k < spectrum.size(); ++k)
  {
    before = sum;
    sum += std::norm(spectrum[k]);
    if (sum >= part * total)
      break;
  }
  const double share = (part * total - before) / (sum - before);
  return std::max(0., k - 0.5 + share) / (padded.size() * interval);
}

std::vector<double> samples_of_whole_pulse(const std::function<double(double)> &signal,
                                           const double end_time,
                                           const std::size_t n)
{
  std::vector<double> samples;
  const auto sample_until = [&](const std::size_t n_samples)
  {
    while (samples.size() < n_samples)
      samples.push_back(signal(samples.size() * end_time / n));
  };
  constexpr std::size_t longest = 8;
  for (std::size_t times = 1; times <= longest; times *= 2)
  {
    sample_until(2 * times * n);
    const auto middle = samples.begin() + times * n;
    const auto all = std::minmax_element(samples.begin(), middle),
               after = std::minmax_element(middle, samples.end());
    if (*after.second - *after.first <= 0.01 * (*all.second - *all.first))
    {
      samples.resize(times * n);
      return samples;
    }
  }
  samples.resize(n);
  return samples;
}
} // namespace Continua
