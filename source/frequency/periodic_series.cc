#include <continua/frequency/periodic_series.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
PeriodicSeries::PeriodicSeries(const double period,
                               const Harmonic &harmonic,
                               const PeriodicSeriesOptions &options)
    : length(period)
{
  if (!(period > 0.) || !(options.tolerance > 0.) || options.n_times < 2 ||
      options.most_harmonics < options.least_harmonics || options.least_harmonics == 0)
    throw std::invalid_argument("a periodic series has a period, a tolerance and harmonics");
  for (unsigned int n = 0; n <= options.most_harmonics && !converged; ++n)
  {
    amplitudes.push_back(harmonic(n));
    if (amplitudes.back().size() != amplitudes.front().size())
      throw std::invalid_argument("harmonics have amplitudes of the same quantities");
    if (n < options.least_harmonics)
      continue;
    measure(options.n_times);
    converged = std::all_of(last_changes.begin(), last_changes.end(),
                            [&](const double change) { return change <= options.tolerance; });
  }
}

double PeriodicSeries::part(const std::size_t quantity,
                            const double time,
                            const unsigned int first,
                            const unsigned int end) const
{
  double sum = 0.;
  for (unsigned int n = first; n < end; ++n)
    sum += (amplitudes[n][quantity] * std::polar(1., 2. * M_PI * n * time / length)).real();
  return sum;
}

double PeriodicSeries::value(const std::size_t quantity, const double time) const
{
  return part(quantity, time, 0, amplitudes.size());
}

void PeriodicSeries::measure(const std::size_t n_times)
{
  const unsigned int end = amplitudes.size(), begin_of_last = end - std::max(1u, n_harmonics() / 3);
  last_changes.assign(amplitudes.front().size(), 0.);
  for (std::size_t q = 0; q < last_changes.size(); ++q)
  {
    double least = value(q, 0.), most = least, change = 0.;
    for (std::size_t j = 0; j < n_times; ++j)
    {
      const double time = length * j / n_times;
      const double now = value(q, time);
      least = std::min(least, now);
      most = std::max(most, now);
      change = std::max(change, std::abs(part(q, time, begin_of_last, end)));
    }
    last_changes[q] = change > 0. ? change / (most - least) : 0.;
  }
}
} // namespace Continua
