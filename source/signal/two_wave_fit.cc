#include <continua/signal/two_wave_fit.h>

#include <continua/base/quiet_gsl.h>
#include <continua/base/undefined.h>
#include <continua/signal/gsl_release.h>

#include <deal.II/base/numbers.h>

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <array>
#include <cmath>
#include <complex>
#include <memory>

namespace Continua
{
namespace
{
using Complex = std::complex<double>;
using ComplexRow = std::vector<Complex>;

/// sigma times the length of the record, of the fit and of the one that it is compared with.
constexpr double decay_over_record = 6., other_decay_over_record = 8.;
/// The part of the largest pressure that bounds the band, and the most frequencies in it.
constexpr double least_pressure_of_band = 0.1;
constexpr unsigned int most_frequencies = 200;
/// The unknowns: 1/c, b, d, e of the slow wave, 1/c of the fast one, kappa, m of both.
constexpr unsigned int n_unknowns = 8;
using Unknowns = std::array<double, n_unknowns>;

struct TwoWaveProblem
{
  std::vector<double> places; ///< from the first station [m]
  std::vector<Complex> s;     ///< [1/s]
  /// By s: pressures, then flow rates times the first impedance [Pa s].
  std::vector<ComplexRow> data;
  double norm = 0.;
  Unknowns scales;

  Complex slow(const Unknowns &of, const Complex s) const
  {
    return of[0] * s + of[1] * std::sqrt(s) + of[2] * s * s + of[3] * s * s * s;
  }

  Unknowns unknowns(const gsl_vector *scaled) const
  {
    Unknowns result;
    for (unsigned int i = 0; i < n_unknowns; ++i)
      result[i] = gsl_vector_get(scaled, i) * scales[i];
    return result;
  }

  /// What is left of the data of one s after the best F and B of both waves.
  ComplexRow rest(const Unknowns &of, const std::size_t frequency) const
  {
    const std::size_t n = places.size();
    const double length = places.back();
    const Complex root = std::sqrt(s[frequency]);
    std::array<ComplexRow, 4> columns;
    for (unsigned int wave = 0; wave < 2; ++wave)
    {
      const Complex g = wave == 0 ? slow(of, s[frequency]) : of[4] * s[frequency];
      const Complex admittance = g / (of[5] * s[frequency] * (1. + of[6 + wave] / root));
      ComplexRow &forward = columns[2 * wave], &backward = columns[2 * wave + 1];
      forward.resize(2 * n);
      backward.resize(2 * n);
      for (std::size_t k = 0; k < n; ++k)
      {
        forward[k] = std::exp(-g * places[k]);
        backward[k] = std::exp(-g * (length - places[k]));
        forward[n + k] = admittance * forward[k];
        backward[n + k] = -admittance * backward[k];
      }
    }
    // What is orthogonal to the columns, which may be almost parallel: each is taken off twice.
    ComplexRow left = data[frequency];
    for (unsigned int c = 0; c < columns.size(); ++c)
    {
      const double size = length_of(columns[c]);
      for (unsigned int round = 0; round < 2; ++round)
        for (unsigned int before = 0; before < c; ++before)
          take_off(columns[before], columns[c]);
      const double independent = length_of(columns[c]);
      // A column of the others alone says nothing.
      const bool counts = independent > 1e-12 * size && std::isfinite(independent);
      for (Complex &entry : columns[c])
        entry = counts ? entry / independent : 0.;
      take_off(columns[c], left);
    }
    return left;
  }

  static double length_of(const ComplexRow &row)
  {
    double sum = 0.;
    for (const Complex &entry : row)
      sum += std::norm(entry);
    return std::sqrt(sum);
  }

  /// Takes the part along a row of length one off another row.
  static void take_off(const ComplexRow &unit, ComplexRow &row)
  {
    Complex product = 0.;
    for (std::size_t i = 0; i < row.size(); ++i)
      product += std::conj(unit[i]) * row[i];
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] -= product * unit[i];
  }
};

int rest_of_two_waves(const gsl_vector *scaled, void *data, gsl_vector *result)
{
  const TwoWaveProblem &problem = *static_cast<const TwoWaveProblem *>(data);
  const Unknowns of = problem.unknowns(scaled);
  std::size_t row = 0;
  for (std::size_t j = 0; j < problem.s.size(); ++j)
    for (const Complex &entry : problem.rest(of, j))
      for (const double part : {entry.real(), entry.imag()})
      {
        if (!std::isfinite(part))
          return GSL_EDOM;
        gsl_vector_set(result, row++, part / problem.norm);
      }
  return GSL_SUCCESS;
}

/// The integral of e^(-st) (values - first value) over the record.
Complex
transform(const std::vector<double> &times, const std::vector<double> &values, const Complex s)
{
  Complex sum = 0.;
  for (std::size_t i = 1; i < times.size(); ++i)
  {
    const double half = 0.5 * (times[i] - times[i - 1]);
    sum += half * (std::exp(-s * (times[i] - times[0])) * (values[i] - values[0]) +
                   std::exp(-s * (times[i - 1] - times[0])) * (values[i - 1] - values[0]));
  }
  return sum;
}

/// The fit with one sigma, times the length of the record.
TwoWaveFit fit_with_decay(const WaveRecord &record,
                          const std::vector<std::size_t> &stations,
                          const double speed,
                          const double decay)
{
  const TwoWaveFit none = {undefined, undefined, undefined};
  TwoWaveProblem problem;
  for (const std::size_t station : stations)
    problem.places.push_back(record.positions[station] - record.positions[stations[0]]);
  const double duration = record.times.back() - record.times.front();
  const double impedance = record.characteristic_impedance[stations[0]];
  double largest = 0., weighted = 0., sum = 0.;
  for (unsigned int j = 0; j < most_frequencies; ++j)
  {
    const Complex s(decay / duration, 2. * dealii::numbers::PI * j / duration);
    ComplexRow row;
    for (const std::size_t station : stations)
      row.push_back(transform(record.times, record.pressure[station], s));
    largest = std::max(largest, std::abs(row[0]));
    if (std::abs(row[0]) < least_pressure_of_band * largest)
      break;
    for (const std::size_t station : stations)
      row.push_back(impedance * transform(record.times, record.flow_rate[station], s));
    weighted += std::norm(row[0]) * s.imag();
    sum += std::norm(row[0]);
    problem.norm = std::hypot(problem.norm, TwoWaveProblem::length_of(row));
    problem.s.push_back(s);
    problem.data.push_back(row);
  }
  if (problem.s.size() < 3 || !(weighted > 0.))
    return none;

  const double omega = weighted / sum, slowness = 1. / speed;
  constexpr double small = 0.05;
  problem.scales = {{slowness, small * slowness * std::sqrt(omega), small * slowness / omega,
                     small * slowness / (omega * omega), 0.25 * slowness, slowness,
                     small * std::sqrt(omega), small * std::sqrt(omega)}};
  const std::array<double, n_unknowns> start = {{1., 1., 0., 0., 1., 1., 1., 1.}};
  const gsl_vector_const_view first = gsl_vector_const_view_array(start.data(), n_unknowns);
  gsl_multifit_nlinear_fdf system{};
  system.f = rest_of_two_waves; // its derivatives are differences
  system.n = 4 * problem.places.size() * problem.s.size();
  system.p = n_unknowns;
  system.params = &problem;
  const QuietGsl quiet;
  gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  settings.fdtype = GSL_MULTIFIT_NLINEAR_CTRDIFF;
  settings.h_df = 1e-5; // of central differences: round-off and error are both about 1e-10
  const std::unique_ptr<gsl_multifit_nlinear_workspace,
                        GslRelease<gsl_multifit_nlinear_workspace, gsl_multifit_nlinear_free>>
      workspace(
          gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, system.n, system.p));
  if (system.n < system.p || !workspace ||
      gsl_multifit_nlinear_init(&first.vector, &system, workspace.get()) != GSL_SUCCESS)
    return none;
  int reason = 0;
  gsl_multifit_nlinear_driver(200, 1e-8, 1e-12, 0., nullptr, nullptr, &reason, workspace.get());
  const Unknowns found = problem.unknowns(gsl_multifit_nlinear_position(workspace.get()));
  TwoWaveFit fit = {0., gsl_blas_dnrm2(gsl_multifit_nlinear_residual(workspace.get())), undefined};
  double weights = 0.;
  for (std::size_t j = 1; j < problem.s.size(); ++j)
  {
    const double weight = std::norm(problem.data[j][0]);
    fit.attenuation += weight * problem.slow(found, Complex(0., problem.s[j].imag())).real();
    weights += weight;
  }
  fit.attenuation /= weights;
  return fit;
}
} // namespace

TwoWaveFit fit_two_waves(const WaveRecord &record,
                         const std::vector<std::size_t> &stations,
                         const double speed)
{
  if (stations.size() < 3 || record.flow_rate.empty() || !(speed > 0.))
    return {undefined, undefined, undefined};
  TwoWaveFit fit = fit_with_decay(record, stations, speed, decay_over_record);
  const TwoWaveFit other = fit_with_decay(record, stations, speed, other_decay_over_record);
  fit.uncertainty = std::abs(other.attenuation / fit.attenuation - 1.);
  return fit;
}
} // namespace Continua
