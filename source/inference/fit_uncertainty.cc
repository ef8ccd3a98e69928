#include <continua/inference/fit_uncertainty.h>

#include <continua/base/six_digits.h>
#include <continua/base/undefined.h>
#include <continua/inference/least_squares_factor.h>

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace Continua
{
namespace
{
using SquareMatrix = dealii::FullMatrix<double>;

/// Residuals below this probability of being white are treated, or told of.
constexpr double least_probability_of_white = 0.01;

/// Rows of one record in the columns of the free parameters.
struct RowRange
{
  std::size_t begin, end;
};

/// sum_(i-k=lag) e_i e_k j_i j_k^T and its transpose, or without e for lag 0 and `errors` null.
void add_products(SquareMatrix &sum,
                  const std::vector<std::vector<double>> &columns,
                  const std::vector<double> *const errors,
                  const RowRange &range,
                  const std::size_t lag,
                  const double weight)
{
  for (unsigned int a = 0; a < columns.size(); ++a)
    for (unsigned int b = 0; b < columns.size(); ++b)
      for (std::size_t i = range.begin + lag; i < range.end; ++i)
      {
        const double product =
            columns[a][i] * columns[b][i - lag] * (errors ? (*errors)[i] * (*errors)[i - lag] : 1.);
        sum(a, b) += weight * product;
        if (lag > 0)
          sum(b, a) += weight * product;
      }
}

/// The lag up to which Newey and West's sum goes: Andrews's, for Bartlett's weights and residuals
/// that are autoregressive of order 1.
std::size_t lag_of_andrews(const std::vector<double> &whitened)
{
  const double n = whitened.size();
  const double r = std::clamp(autocorrelation(whitened, 1)[1], -0.97, 0.97);
  const double alpha = 4. * r * r / std::pow((1. - r) * (1. + r), 2);
  return static_cast<std::size_t>(
      std::min(std::ceil(1.1447 * std::cbrt(alpha * n)), std::floor(0.25 * n)));
}

/// Adds what one record contributes to the middle of the sandwich, and says how.
void add_record(SquareMatrix &middle,
                RecordFit &record,
                const std::vector<std::vector<double>> &columns,
                const std::vector<double> &errors,
                const RowRange &range,
                const bool is_ordered,
                const FitOptions &options,
                const double correction)
{
  record.treatment = record.noise.description();
  const bool is_coloured = record.whiteness.probability < least_probability_of_white;
  if (is_ordered && options.correlated_noise == CorrelatedNoise::enlarged)
  {
    const double ratio =
        fit_autoregressive_model_of_best_order(record.whitened, options.order_criterion, false)
            .largest_spectral_ratio();
    add_products(middle, columns, nullptr, range, 0, ratio);
    record.treatment = "enlarged by " + six_digits(std::sqrt(ratio));
    return;
  }
  if (is_ordered && (options.correlated_noise == CorrelatedNoise::sandwich ||
                     (options.correlated_noise == CorrelatedNoise::autoregressive && is_coloured)))
  {
    const std::size_t lags = lag_of_andrews(record.whitened);
    for (std::size_t lag = 0; lag <= lags; ++lag)
      add_products(middle, columns, &errors, range, lag, correction * (1. - lag / (lags + 1.)));
    record.treatment = (record.noise.is_white() ? "" : record.noise.description() + ", ") +
                       "sandwich over " + std::to_string(lags) + " values";
    return;
  }
  add_products(middle, columns, nullptr, range, 0, 1.);
}

SquareMatrix product_of(const SquareMatrix &a, const SquareMatrix &b)
{
  SquareMatrix result(a.m(), b.n());
  a.mmult(result, b);
  return result;
}

void set_correlation(FitResult &result)
{
  const unsigned int n = result.free.size();
  result.correlation.reinit(n, n);
  for (unsigned int a = 0; a < n; ++a)
    for (unsigned int b = 0; b < n; ++b)
      result.correlation(a, b) =
          a == b ? 1.
                 : result.covariance(a, b) /
                       std::sqrt(result.covariance(a, a) * result.covariance(b, b));
}

double student_quantile(const double probability, const double degrees_of_freedom)
{
  return std::isfinite(degrees_of_freedom) ? gsl_cdf_tdist_Pinv(probability, degrees_of_freedom)
                                           : gsl_cdf_ugaussian_Pinv(probability);
}

ConfidenceInterval
within_bounds(const FitParameter &parameter, const double lower, const double upper)
{
  ConfidenceInterval interval{parameter.value(lower), parameter.value(upper), false, false};
  if (!(interval.lower > parameter.lower))
  {
    interval.lower = parameter.lower;
    interval.lower_is_bound = true;
  }
  if (!(interval.upper < parameter.upper))
  {
    interval.upper = parameter.upper;
    interval.upper_is_bound = true;
  }
  return interval;
}

std::vector<std::vector<double>> data_rows(const std::vector<std::vector<double>> &columns,
                                           const std::size_t n_values)
{
  std::vector<std::vector<double>> result = columns;
  for (std::vector<double> &column : result)
    if (!column.empty())
      column.resize(n_values);
  return result;
}

/// Plain covariance of the coordinates of some columns, and the one with the treatment of each
/// record, which is noted in the records. The two are equal if a direction is not seen.
struct Covariances
{
  SquareMatrix plain, treated;
};

Covariances covariances_of(const std::vector<std::vector<double>> &columns,
                           const std::vector<double> &rows,
                           const std::vector<DataRecord> &records,
                           const FitOptions &options,
                           std::vector<RecordFit> &record_fits)
{
  Covariances result;
  result.plain = LeastSquaresFactor(columns).inverse_of_normal_matrix();
  result.treated = result.plain;
  const unsigned int n = columns.size();
  std::size_t n_values = 0;
  for (const DataRecord &record : records)
    n_values += record.size();
  const double correction = n_values > n ? static_cast<double>(n_values) / (n_values - n) : 1.;
  SquareMatrix middle(n, n);
  std::size_t begin = 0;
  for (std::size_t r = 0; r < records.size(); ++r)
  {
    const RowRange range{begin, begin + records[r].size()};
    begin = range.end;
    add_record(middle, record_fits[r], columns, rows, range, records[r].interval > 0., options,
               correction);
  }
  add_products(middle, columns, nullptr, {begin, rows.size()}, 0, 1.);
  for (unsigned int a = 0; a < n; ++a)
    if (!std::isfinite(result.plain(a, a)))
      return result;
  result.treated = product_of(product_of(result.plain, middle), result.plain);
  return result;
}

/**
 * Of a parameter at its bound, from there to where chi-square, the others fitted anew, has grown by
 * the square of the one-sided quantile: with the free minimum at d beyond the bound (d <= 0) and
 * the standard error s of the linear model, (x - d)^2/s^2 - d^2/s^2 = q^2. `columns` of the free
 * parameters and of this one, whose treated variance is s^2.
 */
ConfidenceInterval one_sided_interval(const FitParameter &parameter,
                                      const double estimate,
                                      const std::vector<std::vector<double>> &columns,
                                      const std::vector<double> &rows,
                                      const double variance,
                                      const double q)
{
  const bool is_lower = estimate <= parameter.lower;
  const double inwards = is_lower ? 1. : -1.;
  const double beyond = std::min(0., -inwards * LeastSquaresFactor(columns).solve(rows).back());
  const double reach = beyond + std::sqrt(beyond * beyond + q * q * variance);
  const double bound = parameter.coordinate(estimate);
  const double end = bound + inwards * reach;
  return is_lower ? within_bounds(parameter, bound, end) : within_bounds(parameter, end, bound);
}
} // namespace

void set_uncertainty(FitResult &result,
                     const std::vector<FitParameter> &parameters,
                     const std::vector<DataRecord> &records,
                     const std::vector<EstimatedNoise> &estimated,
                     const BoundedMinimiser::Minimum &minimum,
                     const FitOptions &options)
{
  const WeightedResiduals residuals(parameters, records);
  const std::vector<double> rows = residuals.rows(minimum.set, minimum.prediction);
  std::vector<std::vector<double>> columns;
  for (const unsigned int j : result.free)
    columns.push_back(minimum.columns[j]);
  const bool has_estimated = std::any_of(estimated.begin(), estimated.end(),
                                         [](const EstimatedNoise &noise)
                                         { return noise.deviation || noise.n_coefficients > 0; });
  const double all_degrees = has_estimated && result.degrees_of_freedom > 0
                                 ? result.degrees_of_freedom
                                 : std::numeric_limits<double>::infinity();
  result.degrees_of_freedom_of_errors.assign(parameters.size(), all_degrees);
  result.treated_over_plain_variance.assign(parameters.size(), 1.);
  if (!columns.empty())
  {
    const Covariances covariances = covariances_of(columns, rows, records, options, result.records);
    result.covariance = covariances.treated;
    set_correlation(result);
    for (std::size_t k = 0; k < result.free.size(); ++k)
      if (std::isfinite(covariances.plain(k, k)))
        result.treated_over_plain_variance[result.free[k]] =
            covariances.treated(k, k) / covariances.plain(k, k);
    const std::vector<double> degrees =
        degrees_of_freedom_of_errors(records, estimated, columns, result.covariance);
    for (std::size_t k = 0; k < result.free.size(); ++k)
      if (std::isfinite(result.covariance(k, k)))
        result.degrees_of_freedom_of_errors[result.free[k]] = degrees[k];
  }
  result.standard_errors.assign(parameters.size(), undefined);
  result.intervals.assign(parameters.size(), {});
  for (unsigned int j = 0; j < parameters.size(); ++j)
  {
    const FitParameter &parameter = parameters[j];
    const double estimate = result.estimates[j];
    const double degrees = result.degrees_of_freedom_of_errors[j];
    const auto place = std::find(result.free.begin(), result.free.end(), j);
    if (parameter.is_held())
      result.intervals[j] = {estimate, estimate, true, true};
    else if (place == result.free.end())
    {
      std::vector<std::vector<double>> with_this = columns;
      with_this.push_back(minimum.columns[j]);
      const Covariances covariances =
          covariances_of(with_this, rows, records, options, result.records);
      const unsigned int last = with_this.size() - 1;
      const double variance = covariances.treated(last, last);
      if (std::isfinite(variance))
        result.treated_over_plain_variance[j] = variance / covariances.plain(last, last);
      result.intervals[j] = one_sided_interval(parameter, estimate, with_this, rows, variance,
                                               student_quantile(options.confidence, degrees));
    }
    else
    {
      const unsigned int k = place - result.free.begin();
      const double error = std::sqrt(result.covariance(k, k));
      result.standard_errors[j] = error * parameter.value_per_coordinate(estimate);
      const double centre = parameter.coordinate(estimate);
      const double reach = student_quantile(0.5 + 0.5 * options.confidence, degrees) * error;
      result.intervals[j] = within_bounds(parameter, centre - reach, centre + reach);
    }
  }
  result.whitened_jacobian = data_rows(minimum.columns, residuals.n_values());
  result.flat_directions =
      flat_directions(parameters, result.whitened_jacobian, options.flat_factor);
}
} // namespace Continua
