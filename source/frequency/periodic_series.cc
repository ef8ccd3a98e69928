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
    measure(options);
    converged = true;
    for (std::size_t q = 0; q < last_changes.size(); ++q)
      if (options.is_compared.empty() || options.is_compared.at(q))
        converged = converged && last_changes[q] <= options.tolerance;
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

double PeriodicSeries::left_out(const std::size_t quantity, const std::vector<double> &load) const
{
  const std::size_t end = amplitudes.size(), first = end - std::max(1u, n_harmonics() / 3);
  double response = 0., of_load = 0., left = 0.;
  for (std::size_t n = first; n < std::min(end, load.size()); ++n)
  {
    response += std::abs(amplitudes[n][quantity]);
    of_load += load[n];
  }
  for (std::size_t n = end; n < load.size(); ++n)
    left += load[n];
  return of_load > 0. ? left * response / of_load : 0.;
}

void PeriodicSeries::measure(const PeriodicSeriesOptions &options)
{
  const std::size_t end = amplitudes.size(), begin_of_last = end - std::max(1u, n_harmonics() / 3),
                    n_times = options.n_times;
  // All harmonics at all times have one of these phases: a sine for each would be most of the work.
  std::vector<Complex> phases;
  for (std::size_t j = 0; j < n_times; ++j)
    phases.push_back(std::polar(1., 2. * M_PI * j / n_times));
  const auto part_at = [&](const std::size_t q, const std::size_t j, const std::size_t first,
                           const std::size_t behind)
  {
    double sum = 0.;
    for (std::size_t n = first; n < behind; ++n)
    {
      const Complex &amplitude = amplitudes[n][q], &phase = phases[n * j % n_times];
      sum += amplitude.real() * phase.real() - amplitude.imag() * phase.imag();
    }
    return sum;
  };
  last_changes.assign(amplitudes.front().size(), 0.);
  for (std::size_t q = 0; q < last_changes.size(); ++q)
  {
    double least = part_at(q, 0, 0, end), most = least, change = left_out(q, options.load);
    for (std::size_t j = 0; j < n_times; ++j)
    {
      const double of_last = part_at(q, j, begin_of_last, end),
                   now = part_at(q, j, 0, begin_of_last) + of_last;
      least = std::min(least, now);
      most = std::max(most, now);
      change = std::max(change, std::abs(of_last));
    }
    last_changes[q] = change > 0. ? change / (most - least) : 0.;
  }
}
} // namespace Continua
