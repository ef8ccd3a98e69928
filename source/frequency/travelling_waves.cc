#include <continua/frequency/travelling_waves.h>

#include <continua/base/input_error.h>
#include <continua/base/quiet_gsl.h>
#include <continua/base/undefined.h>
#include <continua/frequency/dense_complex_matrix.h>
#include <continua/signal/gsl_release.h>

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace Continua
{
namespace
{
using Complex = std::complex<double>;
using ComplexRow = std::vector<Complex>;

/// Distances of stations that differ by less than this part are equal.
constexpr double equal_distances = 1e-6;
/// Steps of the search over phases, of the line between the first and the last station [rad].
constexpr double phase_step = 0.4;
constexpr unsigned int most_phase_steps = 400;

double size_of(const ComplexRow &row)
{
  double sum = 0.;
  for (const Complex &entry : row)
    sum += std::norm(entry);
  return std::sqrt(sum);
}

Complex product_of(const ComplexRow &unit_row, const ComplexRow &row)
{
  Complex product = 0.;
  for (std::size_t i = 0; i < row.size(); ++i)
    product += std::conj(unit_row[i]) * row[i];
  return product;
}

void take_off(const ComplexRow &unit_row, ComplexRow &row)
{
  const Complex product = product_of(unit_row, row);
  for (std::size_t i = 0; i < row.size(); ++i)
    row[i] -= product * unit_row[i];
}

/// Stations and fields, the lengths over that of the line, the fields over their sizes.
struct WaveLine
{
  std::vector<double> places; ///< 0 to 1
  std::vector<ComplexRow> fields;
  std::vector<double> scales; ///< root mean square of each field

  /// The two directions of each wave at the stations, each of them one where it starts.
  std::vector<ComplexRow> directions(const ComplexRow &propagations) const
  {
    std::vector<ComplexRow> columns;
    for (const Complex &g : propagations)
    {
      ComplexRow forward, backward;
      for (const double z : places)
      {
        forward.push_back(std::exp(-g * z));
        backward.push_back(std::exp(-g * (1. - z)));
      }
      columns.push_back(forward);
      columns.push_back(backward);
    }
    return columns;
  }

  /// Makes the columns orthogonal and of length one; returns the smallest part of a column that
  /// those before it do not have.
  static double orthogonalise(std::vector<ComplexRow> &columns)
  {
    double smallest = 1.;
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      const double size = size_of(columns[c]);
      for (unsigned int round = 0; round < 2; ++round)
        for (std::size_t before = 0; before < c; ++before)
          take_off(columns[before], columns[c]);
      const double left = size_of(columns[c]);
      smallest = std::min(smallest, left / size);
      // A column that the others contain says nothing.
      const bool counts = left > 1e-14 * size && std::isfinite(left);
      for (Complex &entry : columns[c])
        entry = counts ? entry / left : 0.;
    }
    return smallest;
  }

  /// What is left of all fields after the best amplitudes, one after the other.
  ComplexRow rest(const ComplexRow &propagations) const
  {
    std::vector<ComplexRow> columns = directions(propagations);
    orthogonalise(columns);
    ComplexRow result;
    for (ComplexRow left : fields)
    {
      for (const ComplexRow &column : columns)
        take_off(column, left);
      result.insert(result.end(), left.begin(), left.end());
    }
    return result;
  }

  /// Root of the mean square of what is left.
  double misfit(const ComplexRow &propagations) const
  {
    const ComplexRow left = rest(propagations);
    return size_of(left) / std::sqrt(static_cast<double>(left.size()));
  }
};

ComplexRow propagations_of(const gsl_vector *unknowns)
{
  ComplexRow result;
  for (std::size_t k = 0; k + 1 < unknowns->size; k += 2)
    result.emplace_back(gsl_vector_get(unknowns, k), gsl_vector_get(unknowns, k + 1));
  return result;
}

int rest_of_travelling_waves(const gsl_vector *unknowns, void *data, gsl_vector *result)
{
  const WaveLine &line = *static_cast<const WaveLine *>(data);
  std::size_t row = 0;
  for (const Complex &entry : line.rest(propagations_of(unknowns)))
    for (const double part : {entry.real(), entry.imag()})
    {
      if (!std::isfinite(part))
        return GSL_EDOM;
      gsl_vector_set(result, row++, part);
    }
  return GSL_SUCCESS;
}

struct RefinedWaves
{
  ComplexRow propagations;
  double misfit = std::numeric_limits<double>::infinity();
  std::vector<double> deviations; ///< of real and imaginary parts
};

/// The fit from a start; infinite misfit where GSL cannot begin.
RefinedWaves refine(const WaveLine &line, const ComplexRow &start)
{
  RefinedWaves result;
  std::vector<double> first;
  for (const Complex &g : start)
    for (const double part : {g.real(), g.imag()})
      first.push_back(part);
  const std::size_t n = 2 * line.fields.size() * line.places.size(), p = first.size();
  const gsl_vector_const_view view = gsl_vector_const_view_array(first.data(), p);
  gsl_multifit_nlinear_fdf system{};
  system.f = rest_of_travelling_waves; // its derivatives are differences
  system.n = n;
  system.p = p;
  system.params = const_cast<WaveLine *>(&line);
  const QuietGsl quiet;
  gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  settings.fdtype = GSL_MULTIFIT_NLINEAR_CTRDIFF;
  settings.h_df = 1e-5; // of central differences: round-off and error are both about 1e-10
  const std::unique_ptr<gsl_multifit_nlinear_workspace,
                        GslRelease<gsl_multifit_nlinear_workspace, gsl_multifit_nlinear_free>>
      workspace(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, n, p));
  if (!workspace ||
      gsl_multifit_nlinear_init(&view.vector, &system, workspace.get()) != GSL_SUCCESS)
    return result;
  int reason = 0;
  gsl_multifit_nlinear_driver(200, 1e-12, 1e-14, 0., nullptr, nullptr, &reason, workspace.get());
  result.propagations = propagations_of(gsl_multifit_nlinear_position(workspace.get()));
  result.misfit = line.misfit(result.propagations);
  // Of the complex numbers two for each wave and field are amplitudes.
  const double n_free = static_cast<double>(n) - p - 2. * p * line.fields.size();
  result.deviations.assign(p, undefined);
  if (n_free > 0.5)
  {
    std::vector<double> covariance(p * p);
    gsl_matrix_view matrix = gsl_matrix_view_array(covariance.data(), p, p);
    gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(workspace.get()), 0., &matrix.matrix);
    const double variance = result.misfit * result.misfit * (0.5 * n) / n_free;
    for (std::size_t k = 0; k < p; ++k)
      result.deviations[k] = std::sqrt(covariance[k * p + k] * variance);
  }
  return result;
}

/// The sign for which the wave goes forward, or decays where it hardly goes.
Complex forward_sign(const Complex g)
{
  const bool hardly_goes = std::abs(g.imag()) < 1e-3 * std::abs(g.real());
  return (hardly_goes ? g.real() : g.imag()) < 0. ? -g : g;
}

/// Starts from stations at equal distances: the recurrence over `lag` stations, whose coefficients
/// c_i of T_i(cosh(g d)) are found by least squares.
ComplexRow
start_by_recurrence(const WaveLine &line, const unsigned int n_waves, const std::size_t lag)
{
  const std::size_t n = line.places.size(), reach = n_waves * lag, n_rows = n - 2 * reach;
  DenseComplexMatrix matrix(n_rows * line.fields.size(), n_waves);
  ComplexRow right;
  for (const ComplexRow &field : line.fields)
    for (std::size_t j = reach; j < n - reach; ++j)
    {
      for (unsigned int i = 0; i < n_waves; ++i)
        matrix(right.size(), i) = i == 0 ? field[j] : field[j - i * lag] + field[j + i * lag];
      right.push_back(-field[j - reach] - field[j + reach]);
    }
  const ComplexRow c = least_squares_solution(matrix, right);
  // c_0 + 2 c_1 T_1 + ... + 2 T_n = 0: the values of the colleague matrix of Chebyshev polynomials.
  DenseComplexMatrix colleague(n_waves, n_waves), one(n_waves, n_waves);
  for (unsigned int i = 0; i < n_waves; ++i)
  {
    one(i, i) = 1.;
    if (i + 1 < n_waves)
      colleague(i, i + 1) = i == 0 ? 1. : 0.5;
    if (i > 0)
      colleague(i, i - 1) += 0.5;
  }
  for (unsigned int i = 0; i < n_waves; ++i)
    colleague(n_waves - 1, i) -= n_waves == 1 ? 0.5 * c[i] : (i == 0 ? 0.25 : 0.5) * c[i];
  const double distance = lag / (n - 1.);
  ComplexRow result;
  for (const Complex &value : generalised_eigenvalues(colleague, one))
    result.push_back(forward_sign(std::acosh(value)) / distance);
  return result;
}

/// Adds waves one by one, each at the phase that leaves least.
ComplexRow start_by_search(const WaveLine &line, const unsigned int n_waves)
{
  double gap = 1.;
  for (std::size_t k = 1; k < line.places.size(); ++k)
    gap = std::min(gap, line.places[k] - line.places[k - 1]);
  ComplexRow found;
  while (found.size() < n_waves)
  {
    ComplexRow best = found;
    double least = std::numeric_limits<double>::infinity();
    for (unsigned int i = 1; i <= most_phase_steps && i * phase_step * gap < M_PI; ++i)
    {
      ComplexRow trial = found;
      trial.emplace_back(0., i * phase_step);
      if (const double left = line.misfit(trial); left < least)
      {
        least = left;
        best = trial;
      }
    }
    if (best.size() == found.size())
      best.emplace_back(0., phase_step);
    const RefinedWaves refined = refine(line, best);
    found = std::isfinite(refined.misfit) ? refined.propagations : best;
  }
  return found;
}

bool are_equidistant(const std::vector<double> &places)
{
  const double distance = 1. / (places.size() - 1.);
  for (std::size_t k = 0; k < places.size(); ++k)
    if (std::abs(places[k] - k * distance) > equal_distances * distance)
      return false;
  return true;
}

RefinedWaves best_of_starts(const WaveLine &line, const TravellingWavesOptions &options)
{
  std::vector<ComplexRow> starts;
  const std::size_t n = line.places.size();
  if (!options.start.empty())
    starts.push_back(options.start);
  else
  {
    if (are_equidistant(line.places))
      for (std::size_t lag = 1; std::size_t{2} * options.n_waves * lag < n; lag *= 2)
        if ((n - std::size_t{2} * options.n_waves * lag) * line.fields.size() >= options.n_waves)
          try
          {
            starts.push_back(start_by_recurrence(line, options.n_waves, lag));
          }
          catch (const RunError &)
          {
            // Fields that do not tell the waves apart over this lag: others may.
          }
    if (starts.empty() || n > 2 * options.n_waves + 1)
      starts.push_back(start_by_search(line, options.n_waves));
  }
  RefinedWaves best;
  for (const ComplexRow &start : starts)
  {
    // Of equally good fits the first one counts, which has the longest waves.
    const RefinedWaves refined = refine(line, start);
    if (refined.misfit < 0.99 * best.misfit && best.misfit > 1e-10)
      best = refined;
  }
  return best;
}

WaveLine line_of(const std::vector<double> &positions, const std::vector<ComplexRow> &fields)
{
  WaveLine line;
  const double length = positions.back() - positions.front();
  for (const double position : positions)
    line.places.push_back((position - positions.front()) / length);
  for (const ComplexRow &field : fields)
  {
    const double scale = size_of(field) / std::sqrt(static_cast<double>(field.size()));
    if (!(scale > 0.) || !std::isfinite(scale))
      continue;
    line.scales.push_back(scale);
    line.fields.push_back(field);
    for (Complex &value : line.fields.back())
      value /= scale;
  }
  return line;
}

void add_amplitudes(const WaveLine &line, const ComplexRow &propagations, TravellingWaves &result)
{
  const std::vector<ComplexRow> columns = line.directions(propagations);
  DenseComplexMatrix matrix(line.places.size(), columns.size());
  for (std::size_t i = 0; i < line.places.size(); ++i)
    for (std::size_t c = 0; c < columns.size(); ++c)
      matrix(i, c) = columns[c][i];
  for (std::size_t f = 0; f < line.fields.size(); ++f)
  {
    const ComplexRow amplitudes = least_squares_solution(matrix, line.fields[f]);
    for (std::size_t k = 0; k < propagations.size(); ++k)
    {
      result.waves[k].forward.push_back(line.scales[f] * amplitudes[2 * k]);
      result.waves[k].backward.push_back(line.scales[f] * amplitudes[2 * k + 1]);
    }
  }
}
} // namespace

TravellingWaves fit_travelling_waves(const std::vector<double> &positions,
                                     const std::vector<std::vector<Complex>> &fields,
                                     const double angular_frequency,
                                     const TravellingWavesOptions &options)
{
  const std::size_t n = positions.size();
  if (!(angular_frequency > 0.))
    throw std::invalid_argument("waves have a positive frequency");
  if (options.n_waves == 0 || (!options.start.empty() && options.start.size() != options.n_waves))
    throw std::invalid_argument("a start has a number for each wave");
  for (std::size_t k = 1; k < n; ++k)
    if (!(positions[k] > positions[k - 1]))
      throw std::invalid_argument("positions of stations increase");
  for (const std::vector<Complex> &field : fields)
    if (field.size() != n)
      throw std::invalid_argument("a field has a value for each station");

  TravellingWaves result{{}, undefined, undefined, ""};
  const std::size_t n_least = 2 * options.n_waves + 1;
  if (n < n_least)
  {
    result.refusal = std::to_string(n_least) + " stations are the least for " +
                     std::to_string(options.n_waves) + " waves that go both ways, and there are " +
                     std::to_string(n);
    return result;
  }
  WaveLine line = line_of(positions, fields);
  if (line.fields.empty() ||
      (n - std::size_t{2} * options.n_waves) * line.fields.size() < options.n_waves)
  {
    result.refusal = "there are fewer values than unknown numbers of the waves";
    return result;
  }
  const double length = positions.back() - positions.front();
  TravellingWavesOptions scaled = options;
  for (Complex &g : scaled.start)
    g *= length;
  const RefinedWaves fit = best_of_starts(line, scaled);
  if (!std::isfinite(fit.misfit))
  {
    result.refusal = "the fit of the waves does not converge";
    return result;
  }
  result.misfit = fit.misfit;
  std::vector<ComplexRow> columns = line.directions(fit.propagations);
  result.independence = WaveLine::orthogonalise(columns);
  if (!(result.independence >= options.least_independence))
  {
    double longest = std::numeric_limits<double>::infinity();
    for (const Complex &g : fit.propagations)
      longest = std::min(longest, std::abs(g));
    result.refusal = longest < 1. ? "the stations are too near to each other for the waves at this "
                                    "frequency: spread them over a sixth of a wave at least"
                                  : "the stations do not tell the waves and their directions apart "
                                    "at this frequency, as at multiples of half a wave: move a "
                                    "station";
    return result;
  }
  for (std::size_t k = 0; k < fit.propagations.size(); ++k)
  {
    const Complex g = forward_sign(fit.propagations[k]) / length;
    const double speed = angular_frequency / g.imag();
    result.waves.push_back(
        {g,
         speed,
         g.real(),
         std::abs(speed) * fit.deviations[2 * k + 1] / (length * std::abs(g.imag())),
         fit.deviations[2 * k] / length,
         {},
         {}});
  }
  ComplexRow propagations;
  for (const TravellingWave &wave : result.waves)
    propagations.push_back(wave.propagation * length);
  add_amplitudes(line, propagations, result);
  std::stable_sort(result.waves.begin(), result.waves.end(),
                   [](const TravellingWave &a, const TravellingWave &b)
                   { return a.propagation.imag() > b.propagation.imag(); });
  return result;
}
} // namespace Continua
