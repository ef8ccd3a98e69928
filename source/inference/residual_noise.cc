#include <continua/inference/residual_noise.h>

#include <continua/base/input_error.h>
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

std::vector<DataRecord> ResidualNoise::estimate(const std::vector<std::vector<double>> &residuals,
                                                const std::vector<double> &n_taken)
{
  ++n_estimates;
  std::vector<DataRecord> records = given;
  for (unsigned int r = 0; r < records.size(); ++r)
  {
    DataRecord &record = records[r];
    const double scatter = mean_of_squares(residuals[r]);
    const bool has_residuals = std::sqrt(scatter) > least_deviation(record);
    if (finds_correlation(r) && has_residuals && residuals[r].size() >= 10)
    {
      // An order that changes for ever would keep the fit from ending.
      const AutoregressiveModel model =
          n_estimates <= 2 || !orders[r]
              ? fit_autoregressive_model_of_best_order(residuals[r], options.order_criterion, false)
              : fit_autoregressive_model(residuals[r], *orders[r], false);
      orders[r] = model.coefficients.size();
      record.noise.autoregressive = model.coefficients;
    }
    if (!deviation_is_unknown(r))
      continue;
    const double n_left = record.size() - n_taken[r];
    if (n_left < 0.5)
      throw RunError("the record '" + record.name +
                     "' has too few values to tell its noise: state the standard deviation");
    record.noise.standard_deviation = 1.;
    const double square =
        has_residuals
            ? mean_of_squares(Whitening(record.noise, record.interval).apply(residuals[r])) *
                  record.size() / n_left
            : 0.;
    record.noise.standard_deviation = std::max(std::sqrt(square), least_deviation(record));
  }
  return records;
}
} // namespace Continua
