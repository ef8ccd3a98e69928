#include <continua/inference/expected_errors.h>

#include <continua/base/input_error.h>
#include <continua/inference/least_squares_factor.h>
#include <continua/inference/model_derivatives.h>
#include <continua/inference/whitening.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace Continua
{
namespace
{
/// Sets of `n_chosen` of the numbers 0 ... n - 1.
std::vector<std::vector<unsigned int>> combinations(const unsigned int n,
                                                    const unsigned int n_chosen)
{
  std::vector<std::vector<unsigned int>> result;
  std::vector<unsigned int> chosen(n_chosen);
  std::iota(chosen.begin(), chosen.end(), 0U);
  while (n_chosen <= n)
  {
    result.push_back(chosen);
    unsigned int place = n_chosen;
    while (place > 0 && chosen[place - 1] == n - n_chosen + place - 1)
      --place;
    if (place == 0)
      break;
    ++chosen[place - 1];
    for (unsigned int k = place; k < n_chosen; ++k)
      chosen[k] = chosen[k - 1] + 1;
  }
  return result;
}
} // namespace

ExpectedErrors::ExpectedErrors(std::vector<FitParameter> fit_parameters,
                               const std::vector<DataRecord> &records,
                               FitModel &fit_model,
                               const double difference_step,
                               const double flat)
    : parameters(std::move(fit_parameters)), flat_factor(flat)
{
  check_fit_parameters(parameters);
  check_data_records(records, false);
  std::size_t n_values = 0;
  for (const DataRecord &record : records)
    n_values += record.size();
  std::vector<double> start;
  for (unsigned int j = 0; j < parameters.size(); ++j)
  {
    start.push_back(parameters[j].start);
    if (!parameters[j].is_held())
      not_held.push_back(j);
  }
  if (not_held.empty())
    throw std::invalid_argument("there is no parameter to be found");
  EvaluatedModel model(fit_model, n_values);
  const ModelDerivatives derivatives =
      model_derivatives(parameters, model, start, not_held, difference_step);
  if (!derivatives.failure.empty())
    throw RunError(derivatives.failure);
  std::vector<std::vector<std::vector<double>>> pieces;
  for (const unsigned int j : not_held)
    pieces.push_back(by_record(records, derivatives.columns[j]));
  for (std::size_t r = 0; r < records.size(); ++r)
  {
    const Whitening whitening(records[r].noise, records[r].interval);
    std::vector<std::vector<double>> whitened;
    for (const auto &piece : pieces)
    {
      whitened.push_back(whitening.apply(piece[r]));
      whitened.back().resize(std::max(records[r].size(), not_held.size()), 0.);
    }
    columns.push_back(LeastSquaresFactor(whitened).short_columns());
  }
}

dealii::FullMatrix<double> ExpectedErrors::information(const unsigned int record) const
{
  const auto &of_record = columns.at(record);
  dealii::FullMatrix<double> result(not_held.size(), not_held.size());
  for (unsigned int a = 0; a < not_held.size(); ++a)
    for (unsigned int b = 0; b < not_held.size(); ++b)
      result(a, b) =
          std::inner_product(of_record[a].begin(), of_record[a].end(), of_record[b].begin(), 0.);
  return result;
}

ExpectedErrors::Errors ExpectedErrors::of(const std::vector<unsigned int> &chosen) const
{
  const unsigned int n = not_held.size();
  std::vector<std::vector<double>> seen(parameters.size()), rows(n);
  for (unsigned int k = 0; k < n; ++k)
  {
    std::vector<double> &column = seen[not_held[k]];
    for (const unsigned int record : chosen)
      column.insert(column.end(), columns.at(record)[k].begin(), columns.at(record)[k].end());
    column.resize(std::max<std::size_t>(column.size(), n), 0.);
    rows[k] = column;
    for (const unsigned int j : not_held)
    {
      const FitParameter &parameter = parameters[j];
      const bool has_prior = j == not_held[k] && parameter.prior;
      rows[k].push_back(has_prior ? parameter.value_per_coordinate(parameter.prior->mean) /
                                        parameter.prior->standard_deviation
                                  : 0.);
    }
  }
  Errors errors;
  const dealii::FullMatrix<double> covariance = LeastSquaresFactor(rows).inverse_of_normal_matrix();
  errors.standard_errors.assign(parameters.size(), 0.);
  errors.correlation.reinit(n, n);
  for (unsigned int a = 0; a < n; ++a)
  {
    const FitParameter &parameter = parameters[not_held[a]];
    errors.standard_errors[not_held[a]] =
        std::sqrt(covariance(a, a)) * parameter.value_per_coordinate(parameter.start);
    for (unsigned int b = 0; b < n; ++b)
      errors.correlation(a, b) =
          a == b ? 1. : covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b));
    for (double &value : rows[a])
      value *= parameter.size();
  }
  errors.log_determinant = LeastSquaresFactor(rows).log_determinant();
  errors.flat_directions = flat_directions(parameters, seen, flat_factor);
  return errors;
}

ExpectedErrors::Errors ExpectedErrors::of_all() const
{
  std::vector<unsigned int> all(columns.size());
  std::iota(all.begin(), all.end(), 0U);
  return of(all);
}

std::vector<ExpectedErrors::Choice>
ExpectedErrors::rank(const std::vector<unsigned int> &always,
                     const std::vector<std::vector<unsigned int>> &candidates,
                     const unsigned int n_chosen,
                     const unsigned int parameter) const
{
  std::vector<Choice> choices;
  for (const std::vector<unsigned int> &chosen : combinations(candidates.size(), n_chosen))
  {
    std::vector<unsigned int> records = always;
    for (const unsigned int candidate : chosen)
      for (const unsigned int record : candidates[candidate])
        if (std::find(records.begin(), records.end(), record) == records.end())
          records.push_back(record);
    choices.push_back({chosen, of(records)});
  }
  std::stable_sort(choices.begin(), choices.end(),
                   [&](const Choice &a, const Choice &b)
                   {
                     if (parameter == by_determinant)
                       return a.errors.log_determinant > b.errors.log_determinant;
                     return a.errors.standard_errors.at(parameter) <
                            b.errors.standard_errors.at(parameter);
                   });
  return choices;
}
} // namespace Continua
