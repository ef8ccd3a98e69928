#include <continua/inference/interpolated_model.h>

#include <continua/base/input_error.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace Continua
{
namespace
{
/// Chebyshev's nodes of the first kind; the middle alone where nothing varies.
std::vector<double> chebyshev_nodes(const unsigned int n)
{
  std::vector<double> nodes;
  for (unsigned int i = 0; i < n; ++i)
    nodes.push_back(n == 1 ? 0. : -std::cos(dealii::numbers::PI * (i + 0.5) / n));
  return nodes;
}
} // namespace

InterpolatedModel::InterpolatedModel(FitModel &model,
                                     const std::vector<FitParameter> &parameters,
                                     const std::vector<double> &centre_of_box,
                                     const std::vector<double> &half_widths,
                                     const unsigned int n_nodes)
    : parameters(parameters), half_widths(half_widths)
{
  std::size_t n_values = 1;
  for (std::size_t j = 0; j < parameters.size(); ++j)
  {
    centre.push_back(parameters[j].coordinate(centre_of_box[j]));
    nodes.push_back(chebyshev_nodes(half_widths[j] > 0. ? n_nodes : 1));
    n_values *= nodes.back().size();
  }
  std::vector<std::vector<double>> sets;
  for (std::size_t i = 0; i < n_values; ++i)
  {
    std::size_t rest = i;
    sets.emplace_back();
    for (std::size_t j = 0; j < parameters.size(); ++j)
    {
      sets.back().push_back(
          parameters[j].value(centre[j] + half_widths[j] * nodes[j][rest % nodes[j].size()]));
      rest /= nodes[j].size();
    }
  }
  for (Prediction &prediction : model.predict(sets))
  {
    if (!prediction.failure.empty())
      throw RunError("near the estimates the model fails: " + prediction.failure);
    values.push_back(std::move(prediction.values));
  }
}

std::vector<double> InterpolatedModel::end_of_box(const double sign) const
{
  std::vector<double> result;
  for (std::size_t j = 0; j < parameters.size(); ++j)
    result.push_back(parameters[j].value(centre[j] + sign * half_widths[j]));
  return result;
}

std::vector<double> InterpolatedModel::weights(const unsigned int parameter,
                                               const double coordinate) const
{
  const std::vector<double> &own = nodes[parameter];
  std::vector<double> result(own.size(), 1.);
  if (own.size() == 1)
    return result;
  const double x = (coordinate - centre[parameter]) / half_widths[parameter];
  for (std::size_t i = 0; i < own.size(); ++i)
    for (std::size_t k = 0; k < own.size(); ++k)
      if (k != i)
        result[i] *= (x - own[k]) / (own[i] - own[k]);
  return result;
}

std::vector<FitModel::Prediction>
InterpolatedModel::predict(const std::vector<std::vector<double>> &sets)
{
  std::vector<Prediction> predictions;
  for (const std::vector<double> &set : sets)
  {
    std::vector<std::vector<double>> factors;
    for (std::size_t j = 0; j < parameters.size(); ++j)
      factors.push_back(weights(j, parameters[j].coordinate(set[j])));
    Prediction prediction;
    prediction.values.assign(values.front().size(), 0.);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      std::size_t rest = i;
      double weight = 1.;
      for (const std::vector<double> &factor : factors)
      {
        weight *= factor[rest % factor.size()];
        rest /= factor.size();
      }
      for (std::size_t v = 0; v < values[i].size(); ++v)
        prediction.values[v] += weight * values[i][v];
    }
    predictions.push_back(std::move(prediction));
  }
  return predictions;
}
} // namespace Continua
