#include <continua/theory/impedance_fit.h>

#include <continua/base/quiet_gsl.h>

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_multifit.h>
#include <gsl/gsl_multimin.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace Continua
{
namespace
{
using Complex = std::complex<double>;
constexpr unsigned int largest_n_terms = 16;
/// Singular values of the least squares below this part of the largest one are left out: they
/// would bring large residues that cancel.
constexpr double smallest_singular_value = 1e-11;
/// Of the objective, for what is not passive.
constexpr double penalty = 10.;

template <typename T>
using Owner = std::unique_ptr<T, void (*)(T *)>;

/// Even in the logarithm.
std::vector<double> spread(const double first, const double last, const unsigned int n)
{
  std::vector<double> values;
  for (unsigned int i = 0; i < n; ++i)
    values.push_back(n == 1 ? std::sqrt(first * last)
                            : first * std::pow(last / first, static_cast<double>(i) / (n - 1)));
  return values;
}

/// Fits with given numbers of terms.
class Fitter
{
public:
  explicit Fitter(const std::vector<ImpedanceSample> &samples, const double highest_rate)
      : samples(samples), n_ports(samples.front().value.m()), highest_rate(highest_rate)
  {
    for (unsigned int i = 0; i < n_ports; ++i)
    {
      double sum = 0.;
      for (const ImpedanceSample &sample : samples)
        sum += std::log(std::abs(sample.value(i, i)));
      scales.push_back(std::exp(sum / samples.size()));
    }
  }

  /// The best fit with so many terms, and how passive it is.
  ImpedanceFit best(const unsigned int n_terms, double &passivity) const
  {
    if (n_terms == 0)
      return with_rates({}, passivity);
    double lowest = std::abs(samples.front().s), highest = lowest;
    for (const ImpedanceSample &sample : samples)
    {
      lowest = std::min(lowest, std::abs(sample.s));
      if (sample.weight > 0.1)
        highest = std::max(highest, std::abs(sample.s));
    }
    // From more than one start, since there are several minima.
    double least = std::numeric_limits<double>::infinity();
    std::vector<double> rates;
    for (const double reach : {1., 5.})
    {
      const std::vector<double> found = search(n_terms, 0.5 * lowest, reach * highest);
      double found_passivity = 0.;
      const ImpedanceFit fit = with_rates(found, found_passivity);
      const double value = objective(fit, found_passivity);
      if (value < least)
      {
        least = value;
        rates = found;
      }
    }
    return with_rates(rates, passivity);
  }

private:
  const std::vector<ImpedanceSample> &samples;
  unsigned int n_ports;
  double highest_rate;        ///< [1/s]
  std::vector<double> scales; ///< of each port [Pa s/m^3]

  static double objective(const ImpedanceFit &fit, const double passivity)
  {
    return fit.error + penalty * std::max(0., -passivity);
  }

  std::vector<double> rates_of(const gsl_vector *logarithms, const unsigned int n_terms) const
  {
    const double first = std::exp(gsl_vector_get(logarithms, 0)),
                 last = n_terms == 1 ? first : std::exp(gsl_vector_get(logarithms, 1));
    std::vector<double> rates = spread(first, last, n_terms);
    for (double &rate : rates)
      rate = std::min(rate, highest_rate);
    return rates;
  }

  struct Search
  {
    const Fitter *fitter;
    unsigned int n_terms;
  };

  static double value_of(const gsl_vector *logarithms, void *data)
  {
    const Search &search = *static_cast<Search *>(data);
    const std::vector<double> rates = search.fitter->rates_of(logarithms, search.n_terms);
    double passivity = 0.;
    const ImpedanceFit fit = search.fitter->with_rates(rates, passivity);
    // Rates that would leave the range come back into it.
    const double beyond = std::max(0., gsl_vector_get(logarithms, logarithms->size - 1) -
                                           std::log(search.fitter->highest_rate));
    return objective(fit, passivity) + beyond;
  }

  std::vector<double>
  search(const unsigned int n_terms, const double first, const double last) const
  {
    const unsigned int n = n_terms == 1 ? 1 : 2;
    Search data{this, n_terms};
    gsl_multimin_function function{&value_of, n, &data};
    const Owner<gsl_vector> start(gsl_vector_alloc(n), &gsl_vector_free),
        steps(gsl_vector_alloc(n), &gsl_vector_free);
    gsl_vector_set(start.get(), 0, std::log(n == 1 ? std::sqrt(first * last) : first));
    if (n > 1)
      gsl_vector_set(start.get(), 1, std::log(std::min(last, highest_rate)));
    gsl_vector_set_all(steps.get(), 0.7);
    const Owner<gsl_multimin_fminimizer> minimiser(
        gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, n),
        &gsl_multimin_fminimizer_free);
    gsl_multimin_fminimizer_set(minimiser.get(), &function, start.get(), steps.get());
    for (unsigned int iteration = 0; iteration < 200; ++iteration)
      if (gsl_multimin_fminimizer_iterate(minimiser.get()) != GSL_SUCCESS ||
          gsl_multimin_fminimizer_size(minimiser.get()) < 1e-9)
        break;
    return rates_of(minimiser->x, n_terms);
  }

  /// The least squares of all entries, and the smallest resistance of the result.
  ImpedanceFit with_rates(const std::vector<double> &rates, double &passivity) const
  {
    ImpedanceFit fit;
    fit.impedance.direct.reinit(n_ports, n_ports);
    for (const double rate : rates)
    {
      Impedance::Term term;
      term.rate = rate;
      term.residue.reinit(n_ports, n_ports);
      fit.impedance.terms.push_back(term);
    }
    for (unsigned int i = 0; i < n_ports; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        fit.error = std::max(fit.error, fit_entry(i, j, fit.impedance));
    passivity = smallest_resistance(fit.impedance, scales);
    return fit;
  }

  /// Returns the largest error.
  double fit_entry(const unsigned int i, const unsigned int j, Impedance &impedance) const
  {
    const unsigned int n_rows = 2 * samples.size(), n_columns = 1 + impedance.terms.size();
    const Owner<gsl_matrix> matrix(gsl_matrix_alloc(n_rows, n_columns), &gsl_matrix_free);
    const Owner<gsl_vector> right(gsl_vector_alloc(n_rows), &gsl_vector_free),
        solution(gsl_vector_alloc(n_columns), &gsl_vector_free),
        residual(gsl_vector_alloc(n_rows), &gsl_vector_free);
    const Owner<gsl_matrix> covariance(gsl_matrix_alloc(n_columns, n_columns), &gsl_matrix_free);
    for (std::size_t q = 0; q < samples.size(); ++q)
    {
      const ImpedanceSample &sample = samples[q];
      const double weight =
          sample.weight / std::sqrt(std::abs(sample.value(i, i)) * std::abs(sample.value(j, j)));
      const auto set = [&](const unsigned int column, const Complex &value)
      {
        gsl_matrix_set(matrix.get(), 2 * q, column, value.real());
        gsl_matrix_set(matrix.get(), 2 * q + 1, column, value.imag());
      };
      // Unknown are a share of each rate's plateau, so that all columns are of one size.
      set(0, weight * scale(i, j));
      for (unsigned int k = 0; k < impedance.terms.size(); ++k)
      {
        const double rate = impedance.terms[k].rate;
        set(k + 1, weight * scale(i, j) * rate / (sample.s + rate));
      }
      const Complex value = weight * sample.value(i, j);
      gsl_vector_set(right.get(), 2 * q, value.real());
      gsl_vector_set(right.get(), 2 * q + 1, value.imag());
    }
    const Owner<gsl_multifit_linear_workspace> workspace(
        gsl_multifit_linear_alloc(n_rows, n_columns), &gsl_multifit_linear_free);
    double square = 0.;
    std::size_t rank = 0;
    gsl_multifit_linear_tsvd(matrix.get(), right.get(), smallest_singular_value, solution.get(),
                             covariance.get(), &square, &rank, workspace.get());
    gsl_multifit_linear_residuals(matrix.get(), right.get(), solution.get(), residual.get());
    double error = 0.;
    for (std::size_t q = 0; q < samples.size(); ++q)
      error = std::max(error, std::hypot(gsl_vector_get(residual.get(), 2 * q),
                                         gsl_vector_get(residual.get(), 2 * q + 1)));

    impedance.direct(i, j) = impedance.direct(j, i) =
        scale(i, j) * gsl_vector_get(solution.get(), 0);
    for (unsigned int k = 0; k < impedance.terms.size(); ++k)
    {
      Impedance::Term &term = impedance.terms[k];
      term.residue(i, j) = term.residue(j, i) =
          scale(i, j) * term.rate * gsl_vector_get(solution.get(), k + 1);
    }
    return error;
  }

  double scale(const unsigned int i, const unsigned int j) const
  {
    return std::sqrt(scales[i] * scales[j]);
  }
};
} // namespace

double smallest_resistance(const Impedance &impedance, const std::vector<double> &scales)
{
  const unsigned int n = impedance.n_ports();
  const Owner<gsl_matrix> matrix(gsl_matrix_alloc(n, n), &gsl_matrix_free);
  const Owner<gsl_vector> values(gsl_vector_alloc(n), &gsl_vector_free);
  const Owner<gsl_eigen_symm_workspace> workspace(gsl_eigen_symm_alloc(n), &gsl_eigen_symm_free);
  double smallest = std::numeric_limits<double>::infinity();
  // Of 1/(i omega + rate) the share that resists, rate/(omega^2 + rate^2).
  const auto look = [&](const auto &share)
  {
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
      {
        double sum = impedance.direct(i, j);
        for (const Impedance::Term &term : impedance.terms)
          sum += term.residue(i, j) * share(term.rate);
        gsl_matrix_set(matrix.get(), i, j, sum / std::sqrt(scales[i] * scales[j]));
      }
    gsl_eigen_symm(matrix.get(), values.get(), workspace.get());
    smallest = std::min(smallest, gsl_vector_min(values.get()));
  };
  look([](const double) { return 0.; });
  if (impedance.terms.empty())
    return smallest;
  look([](const double rate) { return 1. / rate; });
  double lowest = impedance.terms.front().rate, highest = lowest;
  for (const Impedance::Term &term : impedance.terms)
  {
    lowest = std::min(lowest, term.rate);
    highest = std::max(highest, term.rate);
  }
  // What varies does so over the rates, and no faster than over a factor of two.
  constexpr unsigned int n_per_decade = 20;
  const unsigned int n_frequencies = 1 + n_per_decade * (4. + std::log10(highest / lowest));
  for (const double omega : spread(0.01 * lowest, 100. * highest, n_frequencies))
    look([omega](const double rate) { return rate / (omega * omega + rate * rate); });
  return smallest;
}

ImpedanceFit fit_impedance(const std::vector<ImpedanceSample> &samples,
                           const double tolerance,
                           const double highest_rate)
{
  const QuietGsl quiet;
  const Fitter fitter(samples, highest_rate);
  ImpedanceFit best;
  best.error = std::numeric_limits<double>::infinity();
  for (unsigned int n_terms = 0; n_terms <= largest_n_terms; ++n_terms)
  {
    double passivity = 0.;
    const ImpedanceFit fit = fitter.best(n_terms, passivity);
    if (passivity > 0. && fit.error < best.error)
      best = fit;
    if (best.error <= tolerance)
      break;
  }
  return best;
}
} // namespace Continua
