#include <continua/inference/evaluated_model.h>

#include <continua/base/undefined.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace Continua
{
EvaluatedModel::EvaluatedModel(FitModel &model,
                               const std::size_t n_values,
                               const std::vector<Evaluation> &known,
                               EvaluationObserver observer)
    : model(model), n_values(n_values), observer(std::move(observer))
{
  for (const Evaluation &evaluation : known)
    if (!evaluation.prediction.failure.empty() || evaluation.prediction.values.size() == n_values)
      kept[evaluation.set] = evaluation.prediction;
}

void EvaluatedModel::set_misfit(
    std::function<double(const std::vector<double> &, const std::vector<double> &)> misfit)
{
  misfit_of = std::move(misfit);
}

std::vector<FitModel::Prediction>
EvaluatedModel::predict(const std::vector<std::vector<double>> &sets, const std::string &purpose)
{
  std::vector<std::vector<double>> unknown;
  for (const std::vector<double> &set : sets)
    if (kept.count(set) == 0 && std::find(unknown.begin(), unknown.end(), set) == unknown.end())
      unknown.push_back(set);
  if (!unknown.empty())
  {
    std::vector<FitModel::Prediction> predictions = model.predict(unknown);
    if (predictions.size() != unknown.size())
      throw std::logic_error("a model gave another number of predictions than it was asked for");
    for (std::size_t i = 0; i < unknown.size(); ++i)
    {
      FitModel::Prediction &prediction = predictions[i];
      if (prediction.failure.empty() && prediction.values.size() != n_values)
        prediction.failure = "the model predicted " + std::to_string(prediction.values.size()) +
                             " values for " + std::to_string(n_values) + " of data";
      if (prediction.failure.empty() &&
          !std::all_of(prediction.values.begin(), prediction.values.end(),
                       [](const double value) { return std::isfinite(value); }))
        prediction.failure = "the model predicted a value that is not finite";
      ++evaluations;
      const bool failed = !prediction.failure.empty();
      if (failed)
      {
        prediction.values.clear();
        ++failures;
        failure = prediction.failure;
      }
      if (observer)
        observer({unknown[i], prediction,
                  failed || !misfit_of ? undefined : misfit_of(unknown[i], prediction.values),
                  purpose});
      kept[unknown[i]] = std::move(prediction);
    }
  }
  std::vector<FitModel::Prediction> result;
  result.reserve(sets.size());
  for (const std::vector<double> &set : sets)
    result.push_back(kept.at(set));
  return result;
}

FitModel::Prediction EvaluatedModel::predict_one(const std::vector<double> &set,
                                                 const std::string &purpose)
{
  return predict(std::vector<std::vector<double>>{set}, purpose).front();
}

bool EvaluatedModel::derivatives(const std::vector<double> &set,
                                 std::vector<std::vector<double>> &by_parameter)
{
  return model.derivatives(set, by_parameter);
}
} // namespace Continua
