#include <continua/inference/restricted_likelihood.h>

#include <continua/base/quiet_gsl.h>
#include <continua/inference/whitening.h>
#include <continua/signal/gsl_release.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multimin.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace Continua
{
namespace
{
/// Coefficients of reflection closer to 1 are those of noise that does not come back.
constexpr double largest_reflection = 0.9999;

/// ln det of a positive matrix, by Cholesky's factor of the matrix with ones on its diagonal. A
/// direction without information counts with round-off, the same for each noise.
double log_determinant_of(const dealii::FullMatrix<double> &matrix)
{
  const unsigned int n = matrix.m();
  dealii::FullMatrix<double> factor(n, n);
  double sum = 0.;
  for (unsigned int j = 0; j < n; ++j)
  {
    const double diagonal = std::max(matrix(j, j), 1e-300);
    sum += std::log(diagonal);
    for (unsigned int i = j; i < n; ++i)
    {
      double value = matrix(i, j) / std::sqrt(diagonal * std::max(matrix(i, i), 1e-300)) +
                     (i == j ? 1e-12 : 0.);
      for (unsigned int k = 0; k < j; ++k)
        value -= factor(i, k) * factor(j, k);
      factor(i, j) = i == j ? std::sqrt(std::max(value, 1e-13)) : value / factor(j, j);
    }
    sum += 2. * std::log(factor(j, j));
  }
  return sum;
}

/// GSL's variables: inverse hyperbolic tangents of the reflections, then ln of the standard
/// deviation.
struct RestrictedLikelihood
{
  const ResidualsOfRecord &record;
  unsigned int order;
  double known_deviation; ///< NaN: a variable

  NoiseModel noise(const gsl_vector *variables) const
  {
    NoiseModel result;
    for (unsigned int m = 1; m <= order; ++m)
    {
      const double reflection = largest_reflection * std::tanh(gsl_vector_get(variables, m - 1));
      std::vector<double> next(m, reflection);
      for (unsigned int j = 0; j + 1 < m; ++j)
        next[j] = result.autoregressive[j] - reflection * result.autoregressive[m - 2 - j];
      result.autoregressive = next;
    }
    result.standard_deviation =
        std::isnan(known_deviation) ? std::exp(gsl_vector_get(variables, order)) : known_deviation;
    return result;
  }

  double value(const gsl_vector *variables) const
  {
    const Whitening whitening(noise(variables), record.interval);
    const std::vector<double> white = whitening.apply(record.residuals);
    std::vector<std::vector<double>> columns;
    for (const std::vector<double> &column : record.columns)
      columns.push_back(whitening.apply(column));
    dealii::FullMatrix<double> information = record.other_information;
    for (unsigned int a = 0; a < columns.size(); ++a)
      for (unsigned int b = 0; b < columns.size(); ++b)
        information(a, b) +=
            std::inner_product(columns[a].begin(), columns[a].end(), columns[b].begin(), 0.);
    return whitening.log_determinant(white.size()) +
           std::inner_product(white.begin(), white.end(), white.begin(), 0.) +
           log_determinant_of(information);
  }

  static double evaluate(const gsl_vector *variables, void *data)
  {
    return static_cast<const RestrictedLikelihood *>(data)->value(variables);
  }
};

/// Coefficients of reflection of an autoregressive model, by Levinson's recursion backwards.
std::vector<double> reflections_of(std::vector<double> coefficients)
{
  std::vector<double> reflections(coefficients.size());
  for (std::size_t m = coefficients.size(); m > 0; --m)
  {
    const double reflection = coefficients[m - 1];
    reflections[m - 1] = reflection;
    std::vector<double> lower(m - 1);
    for (std::size_t j = 0; j + 1 < m; ++j)
      lower[j] =
          (coefficients[j] + reflection * coefficients[m - 2 - j]) / (1. - reflection * reflection);
    coefficients = lower;
  }
  return reflections;
}
} // namespace

NoiseModel restricted_likelihood_noise(const ResidualsOfRecord &record,
                                       const NoiseModel &start,
                                       const bool deviation_is_known)
{
  const unsigned int order = start.autoregressive.size();
  const unsigned int n_variables = order + (deviation_is_known ? 0 : 1);
  if (n_variables == 0)
    return start;
  RestrictedLikelihood likelihood{record, order,
                                  deviation_is_known ? start.standard_deviation : undefined};
  const QuietGsl quiet;
  const std::unique_ptr<gsl_vector, GslRelease<gsl_vector, gsl_vector_free>> variables(
      gsl_vector_alloc(n_variables)),
      steps(gsl_vector_alloc(n_variables));
  const std::vector<double> reflections = reflections_of(start.autoregressive);
  for (unsigned int m = 0; m < order; ++m)
    gsl_vector_set(variables.get(), m,
                   std::atanh(std::clamp(reflections[m] / largest_reflection, -0.999, 0.999)));
  if (!deviation_is_known)
    gsl_vector_set(variables.get(), order, std::log(start.standard_deviation));
  gsl_vector_set_all(steps.get(), 2. / std::sqrt(static_cast<double>(record.residuals.size())));
  const std::unique_ptr<gsl_multimin_fminimizer,
                        GslRelease<gsl_multimin_fminimizer, gsl_multimin_fminimizer_free>>
      minimiser(gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, n_variables));
  gsl_multimin_function function{RestrictedLikelihood::evaluate, n_variables, &likelihood};
  gsl_multimin_fminimizer_set(minimiser.get(), &function, variables.get(), steps.get());
  for (unsigned int k = 0; k < 100 * n_variables; ++k)
    if (gsl_multimin_fminimizer_iterate(minimiser.get()) != GSL_SUCCESS ||
        gsl_multimin_fminimizer_size(minimiser.get()) < 1e-4)
      break;
  return likelihood.noise(gsl_multimin_fminimizer_x(minimiser.get()));
}
} // namespace Continua
