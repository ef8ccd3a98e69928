#include <continua/inference/model_bias.h>

#include <continua/base/undefined.h>
#include <continua/inference/least_squares_factor.h>
#include <continua/inference/weighted_residuals.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace Continua
{
ModelBias model_bias(const std::vector<FitParameter> &parameters,
                     const FitResult &fit,
                     const std::vector<DataRecord> &records,
                     const std::vector<double> &model,
                     const std::vector<double> &other)
{
  if (fit.whitened_jacobian.size() != parameters.size() || fit.free.empty())
    throw std::invalid_argument("the bias of a model needs a fit with derivatives, and a parameter "
                                "that is neither held nor "
                                "at a bound");
  std::vector<DataRecord> weighted = records;
  for (std::size_t r = 0; r < records.size(); ++r)
    weighted[r].noise = fit.records.at(r).noise;
  const WeightedResiduals residuals(parameters, weighted);
  if (model.size() != residuals.n_values() || other.size() != residuals.n_values())
    throw std::invalid_argument("two models are compared by predictions of all values of the fit");
  std::vector<double> difference = other;
  for (std::size_t i = 0; i < difference.size(); ++i)
    difference[i] -= model[i];
  std::vector<double> rows = residuals.whiten(difference);
  rows.resize(residuals.n_rows(), 0.); // the priors do not differ
  std::vector<std::vector<double>> columns;
  for (const unsigned int j : fit.free)
    columns.push_back(residuals.with_priors(j, fit.whitened_jacobian.at(j)));
  const LeastSquaresFactor factor(columns);
  const std::vector<double> changes = factor.solve(rows);

  ModelBias result;
  result.bias.assign(parameters.size(), undefined);
  result.over_standard_error.assign(parameters.size(), undefined);
  for (std::size_t k = 0; k < fit.free.size(); ++k)
  {
    const unsigned int j = fit.free[k];
    const FitParameter &parameter = parameters[j];
    const double estimate = fit.estimates[j];
    result.bias[j] = estimate - parameter.value(parameter.coordinate(estimate) - changes[k]);
    result.over_standard_error[j] =
        changes[k] * parameter.value_per_coordinate(estimate) / fit.standard_errors[j];
  }
  const double explained = factor.length_in_range(rows);
  const double all = std::inner_product(rows.begin(), rows.end(), rows.begin(), 0.);
  result.unexplained = std::sqrt(std::max(0., all - explained * explained));
  return result;
}
} // namespace Continua
