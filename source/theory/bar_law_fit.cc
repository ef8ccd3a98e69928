#include <continua/theory/bar_law_fit.h>

#include <continua/base/input_error.h>
#include <continua/base/undefined.h>
#include <continua/inference/least_squares_fit.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace Continua
{
namespace
{
/// Bounds far from what the records tell of, so that a constant that they do not show ends there.
FitParameter parameter_of(const BarLawConstant &constant,
                          const double start,
                          const std::pair<double, double> &times)
{
  FitParameter parameter;
  parameter.name = constant.name;
  parameter.unit = constant.dimension == Dimensions::none ? "1" : constant.dimension.unit();
  parameter.start = start;
  if (constant.dimension == Dimensions::none)
  {
    // An exponent.
    parameter.lower = 1e-6;
    parameter.upper = 0.999;
  }
  else
  {
    parameter.scale = FitParameter::Scale::logarithmic;
    const bool is_time = constant.dimension == Dimensions::time;
    parameter.lower = is_time ? std::min(1e-3 * times.first, 0.1 * start) : 1e-5 * start;
    parameter.upper = is_time ? std::max(1e3 * times.second, 10. * start) : 1e5 * start;
  }
  return parameter;
}

std::vector<DataRecord> data_of(const std::vector<BarRecord> &records)
{
  std::vector<DataRecord> data;
  for (const BarRecord &record : records)
    data.push_back(record.data_record(undefined));
  return data;
}

/// The constants with the longest relaxation time first; whether they were not in this order.
bool sort_branches(const BarLaw &law, std::vector<double> &constants)
{
  const unsigned int n = law.n_branches();
  std::vector<unsigned int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](const unsigned int a, const unsigned int b)
                   { return constants[1 + n + a] > constants[1 + n + b]; });
  if (std::is_sorted(order.begin(), order.end()))
    return false;
  const std::vector<double> old = constants;
  for (unsigned int k = 0; k < n; ++k)
  {
    constants[1 + k] = old[1 + order[k]];
    constants[1 + n + k] = old[1 + n + order[k]];
  }
  return true;
}

void set_criterion(BarLawFit &fit)
{
  // Of records without noise: round-off of the residuals.
  constexpr double least = 1e-14;
  double sum = 0.;
  std::size_t n_values = 0;
  for (const RecordFit &record : fit.result.records)
  {
    const double misfit = record.root_mean_square;
    fit.misfits.push_back(misfit);
    sum += 2. * record.residuals.size() * std::log(std::max(misfit, least));
    n_values += record.residuals.size();
  }
  fit.criterion = sum + fit.parameters.size() * std::log(static_cast<double>(n_values));
}
} // namespace

BarModel::BarModel(const BarLaw &law, const std::vector<BarRecord> &records)
    : law(law), records(records)
{
}

std::vector<FitModel::Prediction> BarModel::predict(const std::vector<std::vector<double>> &sets)
{
  std::vector<Prediction> predictions;
  for (const std::vector<double> &set : sets)
  {
    Prediction prediction;
    const Material material = law.material(set);
    for (const BarRecord &record : records)
    {
      const std::vector<double> values = record.scaled_prediction(material);
      prediction.values.insert(prediction.values.end(), values.begin(), values.end());
    }
    if (!std::all_of(prediction.values.begin(), prediction.values.end(),
                     [](const double value) { return std::isfinite(value); }))
      prediction = {{}, "the law has no value that a number can hold"};
    predictions.push_back(prediction);
  }
  return predictions;
}

BarLawFit fit_bar_law(const BarLawStart &start, const std::vector<BarRecord> &records)
{
  const std::pair<double, double> times = times_of(records);
  const std::vector<BarLawConstant> constants = start.law->constants();
  BarModel model(*start.law, records);
  BarLawFit fit;
  fit.law = start.law;
  std::vector<double> from = start.constants;
  // A second time where branches have changed places.
  for (unsigned int i = 0; i < 2; ++i)
  {
    fit.parameters.clear();
    for (std::size_t k = 0; k < constants.size(); ++k)
      fit.parameters.push_back(parameter_of(constants[k], from[k], times));
    FitOptions options;
    options.tolerance =
        1e-6; // an evaluation costs nothing, and all digits that are shown are right
    fit.result = LeastSquaresFit(fit.parameters, data_of(records), model, options).solve();
    from = fit.result.estimates;
    if (!sort_branches(*fit.law, from))
      break;
  }
  set_criterion(fit);
  return fit;
}

std::vector<BarLawFit> fit_prony_series_to_bar(const double poissons_ratio,
                                               const std::vector<BarRecord> &records,
                                               const unsigned int most_branches)
{
  std::size_t n_values = 0;
  for (const BarRecord &record : records)
    n_values += record.values.size();
  std::vector<BarLawFit> fits;
  double least = std::numeric_limits<double>::infinity();
  unsigned int n_worse = 0;
  for (const BarLawStart &start : starts_of_prony(poissons_ratio, records, most_branches))
  {
    if (start.constants.size() > most_constants_per_value * n_values || n_worse == 2)
      break;
    try
    {
      const BarLawFit fit = fit_bar_law(start, records);
      if (!fit.result.converged)
        continue;
      fits.push_back(fit);
    }
    catch (const RunError &)
    {
      continue;
    }
    n_worse = fits.back().criterion < least ? 0 : n_worse + 1;
    least = std::min(least, fits.back().criterion);
  }
  return fits;
}

const BarLawFit &best_of(const std::vector<BarLawFit> &fits)
{
  return *std::min_element(fits.begin(), fits.end(),
                           [](const BarLawFit &a, const BarLawFit &b)
                           { return a.criterion < b.criterion; });
}

const BarLawFit &simplest_of(const std::vector<BarLawFit> &fits)
{
  const double least = best_of(fits).criterion;
  return *std::find_if(fits.begin(), fits.end(),
                       [least](const BarLawFit &fit)
                       { return fit.criterion <= least + slight_difference; });
}
} // namespace Continua
