#include <continua/materials/prony_series.h>

#include <continua/base/quiet_gsl.h>

#include <deal.II/base/numbers.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
struct FreeWorkspace
{
  void operator()(gsl_multifit_nlinear_workspace *w) const { gsl_multifit_nlinear_free(w); }
};
using Workspace = std::unique_ptr<gsl_multifit_nlinear_workspace, FreeWorkspace>;

/// The law at angular frequencies [1/s] that are evenly spaced in the logarithm.
struct Samples
{
  std::vector<double> omegas;
  std::vector<std::complex<double>> moduli;

  Samples(const ComplexModulus &law,
          const double lowest,
          const double highest,
          const unsigned int n)
  {
    for (unsigned int i = 0; i < n; ++i)
    {
      const double omega = lowest * std::pow(highest / lowest, i / (n - 1.));
      omegas.push_back(omega);
      moduli.push_back(law(omega));
      // Written so that NaN is refused too.
      if (!(moduli.back().real() > 0.) || !std::isfinite(std::abs(moduli.back())))
      {
        std::ostringstream text;
        text << "the law has no positive storage modulus at " << omega / (2. * PI) << " Hz";
        throw std::domain_error(text.str());
      }
    }
  }
};

/// Logarithms of the spring, of the moduli and of the times: what is fitted.
using Logarithms = std::vector<double>;

PronySeries to_series(const double *p, const std::size_t n_parameters)
{
  const std::size_t n = (n_parameters - 1) / 2;
  PronySeries series;
  series.spring = std::exp(p[0]);
  for (std::size_t k = 1; k <= n; ++k)
  {
    series.moduli.push_back(std::exp(p[k]));
    series.times.push_back(std::exp(p[n + k]));
  }
  return series;
}

/// 1/(1 + i x)
std::complex<double> relaxed(const double x)
{
  const double scale = 1. / (1. + x * x);
  return {scale, -scale * x};
}

/// The relative error and its weight, sample by sample: what GSL makes small.
struct Problem
{
  const Samples &samples;
  std::vector<double> weights; ///< of the squares
};

int residual(const gsl_vector *p, void *data, gsl_vector *result)
{
  const Problem &problem = *static_cast<const Problem *>(data);
  const PronySeries series = to_series(p->data, p->size);
  for (std::size_t i = 0; i < problem.samples.omegas.size(); ++i)
  {
    const std::complex<double> error =
        std::sqrt(problem.weights[i]) *
        (series.modulus(problem.samples.omegas[i]) / problem.samples.moduli[i] - 1.);
    if (!std::isfinite(error.real()) || !std::isfinite(error.imag()))
      return GSL_EDOM;
    gsl_vector_set(result, 2 * i, error.real());
    gsl_vector_set(result, 2 * i + 1, error.imag());
  }
  return GSL_SUCCESS;
}

int jacobian(const gsl_vector *p, void *data, gsl_matrix *result)
{
  const Problem &problem = *static_cast<const Problem *>(data);
  const PronySeries series = to_series(p->data, p->size);
  const std::size_t n = series.moduli.size();
  for (std::size_t i = 0; i < problem.samples.omegas.size(); ++i)
  {
    const std::complex<double> scale = std::sqrt(problem.weights[i]) / problem.samples.moduli[i];
    const auto set = [&](const std::size_t column, const std::complex<double> &value)
    {
      gsl_matrix_set(result, 2 * i, column, value.real());
      gsl_matrix_set(result, 2 * i + 1, column, value.imag());
    };
    set(0, scale * series.spring);
    for (std::size_t k = 0; k < n; ++k)
    {
      // i x/(1 + i x) and its derivative by ln x, i x/(1 + i x)^2.
      const std::complex<double> share = relaxed(problem.samples.omegas[i] * series.times[k]);
      const std::complex<double> derivative = scale * series.moduli[k] * (1. - share);
      set(1 + k, derivative);
      set(1 + n + k, derivative * share);
    }
  }
  return GSL_SUCCESS;
}

/// Improves `p`; leaves it as it is if GSL cannot start from it.
void solve(Problem &problem, Logarithms &p)
{
  gsl_multifit_nlinear_fdf system{};
  system.f = residual;
  system.df = jacobian;
  system.n = 2 * problem.samples.omegas.size();
  system.p = p.size();
  system.params = &problem;
  gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  settings.solver = gsl_multifit_nlinear_solver_cholesky;
  const Workspace workspace(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, system.n, system.p));
  const gsl_vector_view start = gsl_vector_view_array(p.data(), p.size());
  if (!workspace ||
      gsl_multifit_nlinear_init(&start.vector, &system, workspace.get()) != GSL_SUCCESS)
    return;
  // How far it comes is judged by the error that is left, not by GSL's status.
  int reason = 0;
  gsl_multifit_nlinear_driver(100, 1e-7, 1e-14, 0., nullptr, nullptr, &reason, workspace.get());
  const gsl_vector *position = gsl_multifit_nlinear_position(workspace.get());
  for (std::size_t j = 0; j < p.size(); ++j)
    p[j] = gsl_vector_get(position, j);
}

/// |series/law - 1| at every sample.
std::vector<double> errors(const Samples &samples, const Logarithms &p)
{
  const PronySeries series = to_series(p.data(), p.size());
  std::vector<double> result;
  for (std::size_t i = 0; i < samples.omegas.size(); ++i)
    result.push_back(std::abs(series.modulus(samples.omegas[i]) / samples.moduli[i] - 1.));
  return result;
}

double largest_error(const Samples &samples, const Logarithms &p)
{
  double largest = 0.;
  for (const double error : errors(samples, p))
    // Written so that NaN counts as large.
    if (!(error <= largest))
      largest = std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
  return largest;
}

/// Each branch in the middle of its share of the band (in the logarithm), with the rise of the
/// storage modulus there.
Logarithms start(const ComplexModulus &law,
                 const double lowest,
                 const double highest,
                 const unsigned int n_branches)
{
  const Samples edges(law, lowest, highest, n_branches + 1);
  const double least = 1e-3 * edges.moduli.back().real() / n_branches;
  Logarithms p(1 + 2 * n_branches);
  p[0] = std::log(edges.moduli.front().real());
  for (unsigned int k = 1; k <= n_branches; ++k)
  {
    p[k] = std::log(std::max(edges.moduli[k].real() - edges.moduli[k - 1].real(), least));
    p[n_branches + k] = -0.5 * std::log(edges.omegas[k] * edges.omegas[k - 1]);
  }
  return p;
}

/// Moving the weights about halves the largest error; more than this is not to be had from it.
constexpr double most_gained_by_weights = 4.;

/// The best series; it is looked for no further once the error is below `sufficient`, or if it
/// cannot come below `hopeless`.
PronySeries fit(const ComplexModulus &law,
                const double lowest_frequency,
                const double highest_frequency,
                const unsigned int n_branches,
                const double sufficient,
                const double hopeless = std::numeric_limits<double>::infinity())
{
  const double lowest = 2. * PI * lowest_frequency, highest = 2. * PI * highest_frequency;
  // The error has about as many extrema as there are unknowns: some samples to each, and for the
  // error that is reported ten times as many.
  const unsigned int n_unknowns = 1 + 2 * n_branches;
  const unsigned int n_samples =
      std::max(6 * n_unknowns,
               static_cast<unsigned int>(8. * std::log10(highest_frequency / lowest_frequency)));
  const Samples samples(law, lowest, highest, n_samples);
  const Samples fine_samples(law, lowest, highest, 10 * n_samples + 1);
  const QuietGsl quiet;

  Problem problem{samples, std::vector<double>(n_samples, 1.)};
  Logarithms p = start(law, lowest, highest, n_branches), best = p;
  double smallest = std::numeric_limits<double>::infinity();
  constexpr unsigned int n_reweightings = 10;
  for (unsigned int i = 0; i <= n_reweightings; ++i)
  {
    solve(problem, p);
    const double error = largest_error(fine_samples, p);
    const bool settled = i > 2 && error > 0.98 * smallest;
    if (error < smallest)
    {
      smallest = error;
      best = p;
    }
    if (settled || smallest <= sufficient || smallest > most_gained_by_weights * hopeless)
      break;
    const std::vector<double> error_of_sample = errors(samples, p);
    double sum = 0.;
    for (unsigned int j = 0; j < n_samples; ++j)
      sum += problem.weights[j] *= error_of_sample[j];
    // No sample is given up.
    for (double &weight : problem.weights)
      weight = weight * n_samples / sum + 1e-6;
  }

  const PronySeries unsorted = to_series(best.data(), best.size());
  std::vector<unsigned int> order(n_branches);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](const unsigned int a, const unsigned int b)
            { return unsorted.times[a] > unsorted.times[b]; });
  PronySeries series{unsorted.spring, {}, {}, lowest_frequency, highest_frequency, smallest};
  for (const unsigned int k : order)
  {
    series.moduli.push_back(unsorted.moduli[k]);
    series.times.push_back(unsorted.times[k]);
  }
  return series;
}

/// Errors below this are round-off, which weights cannot move.
constexpr double round_off = 1e-10;
} // namespace

std::complex<double> PronySeries::modulus(const double omega) const
{
  std::complex<double> sum = spring;
  for (std::size_t k = 0; k < moduli.size(); ++k)
    sum += moduli[k] * (1. - relaxed(omega * times[k]));
  return sum;
}

PronySeries fit_prony_series(const ComplexModulus &law,
                             const double lowest_frequency,
                             const double highest_frequency,
                             const unsigned int n_branches)
{
  return fit(law, lowest_frequency, highest_frequency, n_branches, round_off);
}

PronySeries fit_prony_series_within(const ComplexModulus &law,
                                    const double lowest_frequency,
                                    const double highest_frequency,
                                    const double tolerance)
{
  // A search by one, then in larger strides: few branches are the rule, and many cost most.
  const auto error_of = [&](const unsigned int n)
  { return fit(law, lowest_frequency, highest_frequency, n, tolerance, tolerance).error; };
  unsigned int too_few = 0, enough = 1;
  double error = error_of(enough), smallest = error;
  while (!(error <= tolerance) && enough < most_prony_branches)
  {
    too_few = enough;
    enough = std::min(enough + std::max(2u, enough / 2), most_prony_branches);
    error = error_of(enough);
    smallest = std::min(smallest, error);
  }
  if (!(error <= tolerance))
  {
    std::ostringstream text;
    text << "no Prony series of up to " << most_prony_branches
         << " branches was found that follows the law closer than " << smallest;
    throw std::range_error(text.str());
  }
  while (enough - too_few > 1)
  {
    const unsigned int middle = (too_few + enough) / 2;
    (error_of(middle) <= tolerance ? enough : too_few) = middle;
  }
  return fit(law, lowest_frequency, highest_frequency, enough, round_off);
}
} // namespace Continua
