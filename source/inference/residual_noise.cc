#include <continua/inference/residual_noise.h>

#include <continua/base/input_error.h>
#include <continua/inference/least_squares_factor.h>
#include <continua/inference/restricted_likelihood.h>
#include <continua/inference/whitening.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace Continua
{
namespace
{
double mean_of_squares(const std::vector<double> &values)
{
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.) / values.size();
}

/// `columns`: whitened by the noise of `record`, rows of all records and of priors.
ResidualsOfRecord residuals_of_record(const DataRecord &record,
                                      const std::vector<double> &residuals,
                                      const std::vector<std::vector<double>> &columns,
                                      const std::size_t begin)
{
  ResidualsOfRecord result;
  result.interval = record.interval;
  result.residuals = residuals;
  const unsigned int n = columns.size();
  const std::size_t end = begin + record.size();
  const Whitening whitening(record.noise, record.interval);
  result.other_information.reinit(n, n);
  for (unsigned int a = 0; a < n; ++a)
  {
    const std::vector<double> &column = columns[a];
    result.columns.push_back(whitening.undo({column.begin() + static_cast<std::ptrdiff_t>(begin),
                                             column.begin() + static_cast<std::ptrdiff_t>(end)}));
    for (unsigned int b = 0; b < n; ++b)
      for (std::size_t i = 0; i < column.size(); ++i)
        if (i < begin || i >= end)
          result.other_information(a, b) += column[i] * columns[b][i];
  }
  return result;
}

/// Below it a standard deviation is round-off of the values.
double least_deviation(const DataRecord &record)
{
  return std::max(1e-12 * std::sqrt(mean_of_squares(record.values)),
                  std::sqrt(std::numeric_limits<double>::min()));
}
} // namespace

ResidualNoise::ResidualNoise(const std::vector<DataRecord> &records, const FitOptions &options)
    : given(records), options(options), orders(records.size())
{
}

bool ResidualNoise::deviation_is_unknown(const unsigned int record) const
{
  return !given[record].noise.standard_deviation_is_known();
}

bool ResidualNoise::finds_correlation(const unsigned int record) const
{
  return options.correlated_noise == CorrelatedNoise::autoregressive &&
         given[record].interval > 0. && given[record].noise.is_white();
}

bool ResidualNoise::has_something_to_estimate() const
{
  for (unsigned int r = 0; r < given.size(); ++r)
    if (deviation_is_unknown(r) || finds_correlation(r))
      return true;
  return false;
}

unsigned int ResidualNoise::n_fitted_coefficients(const unsigned int record) const
{
  return orders[record].value_or(0);
}

std::vector<DataRecord> ResidualNoise::first_guess() const
{
  std::vector<DataRecord> records = given;
  for (DataRecord &record : records)
    if (!record.noise.standard_deviation_is_known())
    {
      const double mean =
          std::accumulate(record.values.begin(), record.values.end(), 0.) / record.size();
      std::vector<double> about_mean = record.values;
      for (double &value : about_mean)
        value -= mean;
      record.noise.standard_deviation =
          std::max(std::sqrt(mean_of_squares(about_mean)), least_deviation(record));
    }
  return records;
}

unsigned int ResidualNoise::order_of(const unsigned int record,
                                     const std::vector<double> &residuals) const
{
  if (!finds_correlation(record) || residuals.size() < 10)
    return 0;
  // An order that changes for ever would keep the fit from ending.
  if (n_estimates > 2 && orders[record])
    return *orders[record];
  return fit_autoregressive_model_of_best_order(residuals, options.order_criterion, false)
      .coefficients.size();
}

std::vector<DataRecord> ResidualNoise::estimate(const std::vector<DataRecord> &weighted,
                                                const std::vector<std::vector<double>> &residuals,
                                                const std::vector<std::vector<double>> &columns)
{
  ++n_estimates;
  std::vector<DataRecord> records = given;
  std::vector<double> leverages(columns.empty() ? 0 : columns.front().size(), 0.);
  if (!columns.empty())
    leverages = LeastSquaresFactor(columns).leverages();
  std::size_t begin = 0;
  for (unsigned int r = 0; r < records.size(); ++r)
  {
    DataRecord &record = records[r];
    const std::size_t end = begin + record.size();
    double n_left = record.size();
    for (std::size_t i = begin; i < end && i < leverages.size(); ++i)
      n_left -= leverages[i];
    if (deviation_is_unknown(r) && n_left < 0.5)
      throw RunError("the record '" + record.name +
                     "' has too few values to tell its noise: state the standard deviation");
    const bool has_residuals = std::sqrt(mean_of_squares(residuals[r])) > least_deviation(record);
    const unsigned int order = has_residuals ? order_of(r, residuals[r]) : 0;
    if (finds_correlation(r))
      orders[r] = order;
    if (order > 0)
    {
      const AutoregressiveModel start = fit_autoregressive_model(residuals[r], order, false);
      NoiseModel noise = record.noise;
      noise.autoregressive = start.coefficients;
      if (deviation_is_unknown(r))
        noise.standard_deviation = start.standard_deviation;
      record.noise = restricted_likelihood_noise(
          residuals_of_record(weighted[r], residuals[r], columns, begin), noise,
          !deviation_is_unknown(r));
    }
    else if (deviation_is_unknown(r))
    {
      record.noise.standard_deviation = 1.;
      const std::vector<double> white =
          Whitening(record.noise, record.interval).apply(residuals[r]);
      record.noise.standard_deviation = std::max(
          std::sqrt(mean_of_squares(white) * record.size() / n_left), least_deviation(record));
    }
    begin = end;
  }
  return records;
}
} // namespace Continua
