#include <continua/theory/bar_law_start.h>

#include <continua/base/input_error.h>
#include <continua/base/nonnegative_least_squares.h>
#include <continua/theory/uniaxial_spectrum.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
/// Values from `lowest` to `highest`, evenly spaced in the logarithm.
std::vector<double> even_in_logarithm(const double lowest, const double highest, const unsigned n)
{
  std::vector<double> values;
  for (unsigned int i = 0; i < n; ++i)
    values.push_back(lowest * std::pow(highest / lowest, i / (n - 1.)));
  return values;
}

/// What is scanned in a law whose modulus is 1 Pa: constants by a time [s] or an exponent [1].
std::vector<std::vector<double>> unit_constants(const BarLaw &law,
                                                const std::pair<double, double> &times)
{
  const std::vector<BarLawConstant> constants = law.constants();
  std::vector<double> scanned = {0.};
  if (constants.size() > 1)
    scanned = constants[1].dimension == Dimensions::none
                  ? even_in_logarithm(1e-3, 0.9, 60)
                  : even_in_logarithm(0.01 * times.first, 100. * times.second, 120);
  std::vector<std::vector<double>> sets;
  for (const double time_or_exponent : scanned)
    sets.push_back(law.unit_constants(time_or_exponent));
  return sets;
}

/// Logarithmic mean of measured over predicted moduli, or of predicted over measured compliances,
/// and the mean square of the differences from it.
struct LogarithmicFit
{
  double modulus = 1.;
  double mean_square = std::numeric_limits<double>::infinity();
};

LogarithmicFit logarithmic_fit(const Material &unit, const std::vector<BarRecord> &records)
{
  std::vector<double> logarithms;
  std::size_t n_left_out = 0;
  for (const BarRecord &record : records)
  {
    const std::vector<double> predicted = record.predicted(unit);
    for (std::size_t i = 0; i < predicted.size(); ++i)
      if (record.values[i] > 0. && predicted[i] > 0.)
        logarithms.push_back((record.quantity == BarQuantity::creep ? -1. : 1.) *
                             std::log(record.values[i] / predicted[i]));
      else
        ++n_left_out;
  }
  LogarithmicFit fit;
  if (logarithms.empty())
    return fit;
  const double mean = std::accumulate(logarithms.begin(), logarithms.end(), 0.) / logarithms.size();
  double sum = n_left_out; // as if each were wrong by a factor e
  for (const double logarithm : logarithms)
    sum += (logarithm - mean) * (logarithm - mean);
  fit.modulus = std::exp(mean);
  fit.mean_square = sum / (logarithms.size() + n_left_out);
  return fit;
}

/// A spring and springs that relax (or, of creep, an elastic compliance and further ones) of given
/// times, whose sum is linear in their moduli (or compliances).
class LinearSeries
{
public:
  explicit LinearSeries(const std::vector<BarRecord> &all)
  {
    for (const BarRecord &record : all)
      if (record.quantity != BarQuantity::creep)
        records.push_back(record);
    is_creep = records.empty();
    if (is_creep)
      records = all;
    for (const BarRecord &record : records)
      for (std::size_t i = 0; i < record.values.size(); ++i)
        measured.push_back(record.values[i] / record.noise_units[i]);
  }

  /// Values of the spring, then of the branches [Pa] (or [1/Pa]).
  NonnegativeLeastSquares solve(const std::vector<double> &times) const
  {
    std::vector<std::vector<double>> columns = {column(std::numeric_limits<double>::infinity())};
    for (const double time : times)
      columns.push_back(column(time));
    try
    {
      return nonnegative_least_squares(columns, measured);
    }
    catch (const std::runtime_error &error)
    {
      throw RunError(error.what());
    }
  }

  /// Spring and moduli [Pa] and relaxation times [s] of a solution, the longest time first.
  std::vector<double> moduli_and_times(const std::vector<double> &values,
                                       const std::vector<double> &times) const;

private:
  bool is_creep;
  std::vector<BarRecord> records;
  std::vector<double> measured;

  std::vector<double> column(const double time) const
  {
    std::vector<double> result;
    for (const BarRecord &record : records)
      for (std::size_t i = 0; i < record.values.size(); ++i)
        result.push_back(value(record, i, time) / record.noise_units[i]);
    return result;
  }

  /// Of a spring of modulus (or compliance) 1 and this time.
  static double value(const BarRecord &record, const std::size_t i, const double tau)
  {
    const double t = record.abscissae[i], loading_time = record.loading_time;
    if (record.quantity == BarQuantity::modulus)
    {
      const double x = 2. * PI * t * tau;
      if (std::isinf(tau))
        return i % 2 == 0 ? 1. : 0.;
      return (i % 2 == 0 ? x * x : x) / (1. + x * x);
    }
    if (record.quantity == BarQuantity::creep)
      return std::isinf(tau) ? 1. : -std::expm1(-t / tau);
    if (loading_time == 0.)
      return std::exp(-t / tau);
    const double held = std::max(t - loading_time, 0.), loaded = t - held;
    return std::isinf(tau)
               ? loaded / loading_time
               : std::exp(-held / tau) * -std::expm1(-loaded / tau) * tau / loading_time;
  }
};

std::vector<double> LinearSeries::moduli_and_times(const std::vector<double> &values,
                                                   const std::vector<double> &times) const
{
  // A branch that the solution leaves out stays small: a logarithm cannot begin at 0.
  const double total = std::accumulate(values.begin(), values.end(), 0.),
               least = 1e-3 * total / values.size();
  UniaxialSpectrum moduli;
  if (is_creep)
  {
    UniaxialSpectrum compliances(std::max(values[0], least));
    for (std::size_t k = 0; k < times.size(); ++k)
      compliances.add(std::max(values[1 + k], least) / times[k], 1. / times[k]);
    moduli = compliances.inverse();
  }
  else
  {
    moduli.add(std::max(values[0], least), 0.);
    for (std::size_t k = 0; k < times.size(); ++k)
      moduli.add(std::max(values[1 + k], least), 1. / times[k]);
  }
  const std::vector<UniaxialSpectrum::Line> &lines = moduli.lines();
  std::vector<double> result;
  for (const UniaxialSpectrum::Line &line : lines)
    result.push_back(line.weight);
  for (std::size_t k = 1; k < lines.size(); ++k)
    result.push_back(1. / lines[k].rate);
  return result;
}

/// Times of the branches that a solution over a fine grid has: neighbours are one branch.
std::vector<double> branch_times(const std::vector<double> &grid, const std::vector<double> &values)
{
  std::vector<double> times;
  double weight = 0., logarithm = 0.;
  for (std::size_t k = 0; k <= grid.size(); ++k)
  {
    const double value = k < grid.size() ? values[1 + k] : 0.;
    if (value > 0.)
    {
      weight += value;
      logarithm += value * std::log(grid[k]);
    }
    else if (weight > 0.)
    {
      times.push_back(std::exp(logarithm / weight));
      weight = logarithm = 0.;
    }
  }
  return times;
}

/// One time less, by whichever way misses least.
std::vector<double> one_less(const LinearSeries &series, const std::vector<double> &times)
{
  const std::vector<double> values = series.solve(times).values;
  std::vector<std::vector<double>> candidates;
  for (std::size_t k = 0; k < times.size(); ++k)
  {
    std::vector<double> without = times;
    without.erase(without.begin() + k);
    candidates.push_back(without);
    if (k + 1 == times.size() || !(values[1 + k] + values[2 + k] > 0.))
      continue;
    const double share = values[1 + k] / (values[1 + k] + values[2 + k]);
    without[k] = std::exp(share * std::log(times[k]) + (1. - share) * std::log(times[k + 1]));
    candidates.push_back(without);
  }
  std::vector<double> best;
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<double> &candidate : candidates)
    if (const double misfit = series.solve(candidate).residual_norm; misfit < least)
    {
      least = misfit;
      best = candidate;
    }
  return best;
}
} // namespace

std::pair<double, double> times_of(const std::vector<BarRecord> &records)
{
  double shortest = std::numeric_limits<double>::infinity(), longest = 0.;
  for (const BarRecord &record : records)
    for (const double abscissa : record.abscissae)
    {
      const double time = record.quantity == BarQuantity::modulus ? 1. / (2. * PI * abscissa)
                          : abscissa > record.loading_time ? abscissa - 0.5 * record.loading_time
                                                           : abscissa;
      shortest = std::min(shortest, time);
      longest = std::max(longest, time);
    }
  return {shortest, longest};
}

BarLawStart start_of_scan(const std::shared_ptr<const BarLaw> &law,
                          const std::vector<BarRecord> &records)
{
  const std::vector<BarLawConstant> of_law = law->constants();
  LogarithmicFit best;
  std::vector<double> constants;
  for (const std::vector<double> &set : unit_constants(*law, times_of(records)))
  {
    const LogarithmicFit fit = logarithmic_fit(law->material(set), records);
    if (!(fit.mean_square < best.mean_square) && !constants.empty())
      continue;
    best = fit;
    constants = set;
    for (std::size_t k = 0; k < constants.size(); ++k)
      if (of_law[k].dimension == Dimensions::pressure ||
          of_law[k].dimension == Dimensions::viscosity)
        constants[k] *= fit.modulus;
  }
  return {law, constants};
}

std::vector<BarLawStart> starts_of_prony(const double poissons_ratio,
                                         const std::vector<BarRecord> &records,
                                         const unsigned int most_branches)
{
  const LinearSeries series(records);
  const auto [shortest, longest] = times_of(records);
  const double lowest = shortest / 3., highest = 3. * longest;
  const std::vector<double> grid = even_in_logarithm(
      lowest, highest, 2 + static_cast<unsigned int>(8. * std::log10(highest / lowest)));
  std::vector<double> times = branch_times(grid, series.solve(grid).values);
  while (times.size() > most_branches)
    times = one_less(series, times);

  const double of_shear = 1. / (2. * (1. + poissons_ratio));
  std::vector<BarLawStart> starts;
  while (true)
  {
    std::vector<double> constants = series.moduli_and_times(series.solve(times).values, times);
    const unsigned int n_branches = constants.size() / 2;
    for (unsigned int k = 1; k <= n_branches; ++k)
      constants[k] *= of_shear;
    starts.push_back({make_series_of_bar(poissons_ratio, n_branches), constants});
    if (times.empty())
      break;
    times = one_less(series, times);
  }
  std::reverse(starts.begin(), starts.end());
  return starts;
}
} // namespace Continua
