#include <continua/inference/least_squares_fit.h>

#include <continua/base/input_error.h>
#include <continua/base/six_digits.h>
#include <continua/base/undefined.h>
#include <continua/inference/bounded_minimiser.h>
#include <continua/inference/fit_uncertainty.h>
#include <continua/inference/residual_noise.h>
#include <continua/inference/start_points.h>

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace Continua
{
namespace
{
using Minimum = BoundedMinimiser::Minimum;

constexpr unsigned int largest_n_noise_estimates = 20;

std::size_t n_values_of(const std::vector<DataRecord> &records)
{
  std::size_t n = 0;
  for (const DataRecord &record : records)
    n += record.size();
  return n;
}

std::vector<std::vector<double>> residuals_by_record(const std::vector<DataRecord> &records,
                                                     const std::vector<double> &prediction)
{
  std::vector<std::vector<double>> residuals = by_record(records, prediction);
  for (std::size_t r = 0; r < records.size(); ++r)
    for (std::size_t i = 0; i < residuals[r].size(); ++i)
      residuals[r][i] = records[r].values[i] - residuals[r][i];
  return residuals;
}

std::vector<unsigned int> free_parameters(const std::vector<FitParameter> &parameters,
                                          const Minimum &minimum)
{
  std::vector<unsigned int> free;
  for (unsigned int j = 0; j < parameters.size(); ++j)
    if (!parameters[j].is_held() && !minimum.at_bound[j])
      free.push_back(j);
  return free;
}

std::vector<std::vector<double>> free_columns(const std::vector<FitParameter> &parameters,
                                              const Minimum &minimum)
{
  std::vector<std::vector<double>> columns;
  for (const unsigned int j : free_parameters(parameters, minimum))
    columns.push_back(minimum.columns[j]);
  return columns;
}

/// The largest change of a standard deviation, relative, and of a coefficient.
double change_of_noise(const std::vector<DataRecord> &before, const std::vector<DataRecord> &after)
{
  double change = 0.;
  for (std::size_t r = 0; r < before.size(); ++r)
  {
    const NoiseModel &a = before[r].noise;
    const NoiseModel &b = after[r].noise;
    change = std::max(change, std::abs(b.standard_deviation / a.standard_deviation - 1.));
    if (a.autoregressive.size() != b.autoregressive.size())
      return 1.;
    for (std::size_t j = 0; j < a.autoregressive.size(); ++j)
      change = std::max(change, std::abs(b.autoregressive[j] - a.autoregressive[j]));
  }
  return change;
}

RecordFit record_fit(const DataRecord &record,
                     const std::vector<double> &prediction,
                     const std::vector<double> &residuals,
                     const ResidualNoise &noise,
                     const unsigned int index)
{
  RecordFit fit;
  fit.prediction = prediction;
  fit.residuals = residuals;
  fit.whitened = Whitening(record.noise, record.interval).apply(residuals);
  fit.root_mean_square =
      std::sqrt(std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.) /
                residuals.size());
  fit.noise = record.noise;
  fit.noise_is_estimated = noise.deviation_is_unknown(index);
  fit.n_fitted_coefficients = noise.n_fitted_coefficients(index);
  fit.whiteness = ljung_box_test(fit.whitened, fit.n_fitted_coefficients);
  if (!(record.interval > 0.))
    fit.whiteness = {undefined, undefined, 0, 0};
  fit.treatment = record.noise.description();
  return fit;
}

/// Sets the records of a result; what of their noise was estimated.
std::vector<EstimatedNoise> set_records(FitResult &result,
                                        const std::vector<DataRecord> &weighted,
                                        const Minimum &minimum,
                                        const ResidualNoise &noise)
{
  const auto predictions = by_record(weighted, minimum.prediction);
  const auto differences = residuals_by_record(weighted, minimum.prediction);
  std::vector<EstimatedNoise> estimated;
  for (unsigned int r = 0; r < weighted.size(); ++r)
  {
    result.records.push_back(record_fit(weighted[r], predictions[r], differences[r], noise, r));
    estimated.push_back({noise.deviation_is_unknown(r), noise.n_fitted_coefficients(r)});
  }
  return estimated;
}

void add_notes(FitResult &result,
               const std::vector<FitParameter> &parameters,
               const std::vector<DataRecord> &records,
               const std::string &last_failure)
{
  if (result.n_failures > 0)
    result.notes.push_back(
        std::to_string(result.n_failures) +
        " evaluations of the model failed, and the fit went around them; the last one: " +
        last_failure);
  for (unsigned int j = 0; j < parameters.size(); ++j)
    if (result.at_bound[j])
      result.notes.push_back("'" + parameters[j].name + "' is at its bound " +
                             six_digits(result.estimates[j]) + " " + parameters[j].unit +
                             ": it has no standard error, and a one-sided interval");
  for (std::size_t r = 0; r < records.size(); ++r)
    if (result.records[r].whiteness.probability < 0.01 &&
        result.records[r].treatment == result.records[r].noise.description())
      result.doubts.push_back("the residuals of '" + records[r].name +
                              "' are correlated (probability of white ones: " +
                              six_digits(result.records[r].whiteness.probability) +
                              "), and no treatment was asked for: the standard errors are wrong");
  if (result.probability_of_misfit < 0.01)
    result.doubts.push_back(
        "the misfit is " + six_digits(result.misfit) + " for " +
        std::to_string(result.degrees_of_freedom) +
        " degrees of freedom: the model does not follow the data within the stated noise, and the "
        "standard errors do not contain this error of the model");
  result.notes.insert(result.notes.end(), result.doubts.begin(), result.doubts.end());
  for (const FlatDirection &direction : result.flat_directions)
    result.notes.push_back(direction.sentence);
}
} // namespace

LeastSquaresFit::LeastSquaresFit(std::vector<FitParameter> fit_parameters,
                                 std::vector<DataRecord> data,
                                 FitModel &fit_model,
                                 FitOptions fit_options)
    : parameters(std::move(fit_parameters)),
      records(std::move(data)),
      options(std::move(fit_options)),
      model(fit_model, n_values_of(records), options.known, options.observer)
{
  check_fit_parameters(parameters);
  check_data_records(records, true);
  std::size_t n_free = 0;
  std::size_t n_rows = n_values_of(records);
  for (const FitParameter &parameter : parameters)
    if (!parameter.is_held())
    {
      ++n_free;
      n_rows += parameter.prior ? 1 : 0;
    }
  if (n_free == 0)
    throw std::invalid_argument("there is no parameter to be found");
  const bool noise_is_known = std::all_of(records.begin(), records.end(),
                                          [](const DataRecord &record)
                                          { return record.noise.standard_deviation_is_known(); });
  if (n_rows < n_free || (n_rows == n_free && !noise_is_known))
    throw std::invalid_argument(std::to_string(n_rows) + " values and priors cannot give " +
                                std::to_string(n_free) + " parameters" +
                                (noise_is_known ? "" : " and the noise"));
}

LeastSquaresFit::~LeastSquaresFit() = default;

FitResult LeastSquaresFit::solve()
{
  ResidualNoise noise(records, options);
  std::vector<DataRecord> weighted = noise.first_guess();
  bool noise_is_known = true;
  for (unsigned int r = 0; r < records.size(); ++r)
    noise_is_known = noise_is_known && !noise.deviation_is_unknown(r);

  FitResult result;
  result.n_iterations = 0;
  const auto minimise = [&](const std::vector<double> &start)
  {
    const WeightedResiduals residuals(parameters, weighted);
    model.set_misfit([&residuals](const std::vector<double> &set, const std::vector<double> &values)
                     { return residuals.misfit(set, values); });
    Minimum minimum =
        BoundedMinimiser(parameters, model, residuals, options, noise_is_known).minimise(start);
    model.set_misfit({});
    result.n_iterations += minimum.n_iterations;
    return minimum;
  };
  Minimum best;
  bool is_found = false;
  for (const std::vector<double> &start : start_points(parameters, options.n_starts))
  {
    const Minimum minimum = minimise(start);
    const bool failed = minimum.prediction.empty();
    result.starts.push_back(
        {start, failed ? std::vector<double>{} : minimum.set, minimum.misfit, minimum.stop_reason});
    if (!failed && (!is_found || (minimum.converged && !best.converged) ||
                    (minimum.converged == best.converged && minimum.misfit < best.misfit)))
    {
      best = minimum;
      is_found = true;
    }
  }
  if (!is_found)
    throw RunError(result.starts.front().stop_reason);

  bool noise_is_settled = !noise.has_something_to_estimate();
  for (unsigned int k = 0; k < largest_n_noise_estimates && !noise_is_settled && best.converged;
       ++k)
  {
    const std::vector<DataRecord> next = noise.estimate(
        weighted, residuals_by_record(weighted, best.prediction), free_columns(parameters, best));
    noise_is_settled = k > 0 && change_of_noise(weighted, next) < 1e-3;
    weighted = next;
    best = minimise(best.set);
  }
  if (!noise_is_settled && best.converged)
    result.notes.emplace_back("noise and parameters still changed after " +
                              std::to_string(largest_n_noise_estimates) +
                              " estimates of the noise");

  const WeightedResiduals residuals(parameters, weighted);
  result.estimates = best.set;
  result.at_bound = best.at_bound;
  result.free = free_parameters(parameters, best);
  result.misfit = best.misfit;
  result.degrees_of_freedom = residuals.n_rows() - result.free.size();
  result.noise_is_known = noise_is_known;
  result.probability_of_misfit = noise_is_known && result.degrees_of_freedom > 0
                                     ? gsl_cdf_chisq_Q(best.misfit, result.degrees_of_freedom)
                                     : undefined;
  result.converged = best.converged;
  result.stop_reason = best.stop_reason;
  result.n_evaluations = model.n_evaluations();
  result.n_failures = model.n_failures();
  const std::vector<EstimatedNoise> estimated = set_records(result, weighted, best, noise);
  if (!best.columns.empty() && !best.columns[result.free.empty() ? 0 : result.free[0]].empty())
    set_uncertainty(result, parameters, weighted, estimated, best, options);
  else
  {
    result.standard_errors.assign(parameters.size(), undefined);
    result.intervals.assign(parameters.size(), {undefined, undefined, false, false});
    result.degrees_of_freedom_of_errors.assign(parameters.size(), undefined);
    result.treated_over_plain_variance.assign(parameters.size(), 1.);
    const unsigned int n_free = result.free.size();
    for (dealii::FullMatrix<double> *const matrix : {&result.covariance, &result.correlation})
    {
      matrix->reinit(n_free, n_free);
      for (unsigned int a = 0; a < n_free; ++a)
        for (unsigned int b = 0; b < n_free; ++b)
          (*matrix)(a, b) = undefined;
    }
    if (n_free > 0)
      result.notes.emplace_back("there are no standard errors, since the derivatives of the model "
                                "at the estimates were not found");
  }
  add_notes(result, parameters, records, model.last_failure());
  return result;
}
} // namespace Continua
