#include <continua/inference/model_derivatives.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Continua
{
namespace
{
/// A derivative as a weighted sum of predictions at distances from the set, in the coordinate.
struct DifferenceFormula
{
  std::vector<double> distances;
  std::vector<double> weights;
};

DifferenceFormula central(const double h)
{
  return {{-h, h}, {-0.5 / h, 0.5 / h}};
}

/// Of second order, to the side of the sign of h.
DifferenceFormula one_sided(const double h)
{
  return {{0., h, 2. * h}, {-1.5 / h, 2. / h, -0.5 / h}};
}

double difference_distance(const FitParameter &parameter, const double at, const double step)
{
  const double size = parameter.size();
  double distance = step * size;
  if (parameter.scale == FitParameter::Scale::linear && parameter.start != 0.)
    distance = step * std::clamp(std::abs(at), 0.01 * size, size);
  const double range =
      parameter.coordinate(parameter.upper) - parameter.coordinate(parameter.lower);
  return std::min(distance, 0.25 * range);
}

bool is_within_bounds(const FitParameter &parameter,
                      const double at,
                      const DifferenceFormula &formula)
{
  const double centre = parameter.coordinate(at);
  return std::all_of(formula.distances.begin(), formula.distances.end(),
                     [&](const double distance)
                     {
                       const double value = parameter.value(centre + distance);
                       return distance == 0. ||
                              (value >= parameter.lower && value <= parameter.upper);
                     });
}

/// Formulas that stay within the bounds, the best one first.
std::vector<DifferenceFormula>
formulas(const FitParameter &parameter, const double at, const double step)
{
  std::vector<DifferenceFormula> result;
  const double distance = difference_distance(parameter, at, step);
  for (const double h : {distance, 0.1 * distance})
    for (const DifferenceFormula &formula : {central(h), one_sided(h), one_sided(-h)})
      if (is_within_bounds(parameter, at, formula))
        result.push_back(formula);
  return result;
}

std::vector<std::vector<double>> sets_of(const FitParameter &parameter,
                                         const unsigned int index,
                                         const std::vector<double> &set,
                                         const DifferenceFormula &formula)
{
  std::vector<std::vector<double>> sets;
  for (const double distance : formula.distances)
  {
    sets.push_back(set);
    if (distance != 0.)
      sets.back()[index] = parameter.value(parameter.coordinate(set[index]) + distance);
  }
  return sets;
}

/// False if one of the predictions failed.
bool add_up(const DifferenceFormula &formula,
            const std::vector<FitModel::Prediction> &predictions,
            const std::size_t first,
            std::vector<double> &column)
{
  column.clear();
  for (std::size_t k = 0; k < formula.weights.size(); ++k)
  {
    const FitModel::Prediction &prediction = predictions[first + k];
    if (!prediction.failure.empty())
      return false;
    column.resize(prediction.values.size(), 0.);
    for (std::size_t i = 0; i < column.size(); ++i)
      column[i] += formula.weights[k] * prediction.values[i];
  }
  return true;
}
} // namespace

ModelDerivatives model_derivatives(const std::vector<FitParameter> &parameters,
                                   EvaluatedModel &model,
                                   const std::vector<double> &set,
                                   const std::vector<unsigned int> &of,
                                   const double step)
{
  ModelDerivatives result;
  result.columns.resize(parameters.size());
  std::vector<std::vector<double>> by_value;
  if (model.derivatives(set, by_value))
  {
    for (const unsigned int j : of)
    {
      result.columns[j] = by_value.at(j);
      for (double &value : result.columns[j])
        value *= parameters[j].value_per_coordinate(set[j]);
    }
    return result;
  }

  // The best formula of all parameters at once, so that the model can compute side by side.
  std::vector<std::vector<double>> sets;
  std::vector<std::vector<DifferenceFormula>> choices;
  for (const unsigned int j : of)
  {
    choices.push_back(formulas(parameters[j], set[j], step));
    const auto more_sets = sets_of(parameters[j], j, set, choices.back().front());
    sets.insert(sets.end(), more_sets.begin(), more_sets.end());
  }
  const std::vector<FitModel::Prediction> predictions = model.predict(sets, "difference");
  std::size_t first = 0;
  for (std::size_t k = 0; k < of.size(); ++k)
  {
    const unsigned int j = of[k];
    bool is_done = add_up(choices[k].front(), predictions, first, result.columns[j]);
    first += choices[k].front().weights.size();
    for (std::size_t other = 1; other < choices[k].size() && !is_done; ++other)
      is_done =
          add_up(choices[k][other],
                 model.predict(sets_of(parameters[j], j, set, choices[k][other]), "difference"), 0,
                 result.columns[j]);
    if (!is_done)
    {
      result.failure =
          "the derivative by '" + parameters[j].name +
          "' cannot be taken, since the model fails on either side: " + model.last_failure();
      return result;
    }
  }
  return result;
}
} // namespace Continua
