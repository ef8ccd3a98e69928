#ifndef continua_inference_evaluated_model_h
#define continua_inference_evaluated_model_h

#include <continua/inference/evaluation.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace Continua
{
/**
 * A FitModel that keeps what it predicted by the values of its parameters, so that no set is
 * computed twice and a fit that is started again replays what it knew. A prediction with another
 * number of values than the records have, or with one that is not finite, is a failure.
 */
class EvaluatedModel
{
public:
  /// `known`: of an earlier fit of the same records. Sets are equal if all numbers are.
  EvaluatedModel(FitModel &model,
                 std::size_t n_values,
                 const std::vector<Evaluation> &known = {},
                 EvaluationObserver observer = {});
  /// Predictions of several sets, those that are not known by one call of the model.
  std::vector<FitModel::Prediction> predict(const std::vector<std::vector<double>> &sets,
                                            const std::string &purpose);
  FitModel::Prediction predict_one(const std::vector<double> &set, const std::string &purpose);
  bool derivatives(const std::vector<double> &set, std::vector<std::vector<double>> &by_parameter);
  /// Chi-square of a prediction, told to the observer.
  void set_misfit(std::function<double(const std::vector<double> &set,
                                       const std::vector<double> &prediction)> misfit_of);
  unsigned int n_evaluations() const { return evaluations; } ///< made by the model, not replayed
  unsigned int n_failures() const { return failures; }
  const std::string &last_failure() const { return failure; }

private:
  FitModel &model;
  std::size_t n_values;
  EvaluationObserver observer;
  std::map<std::vector<double>, FitModel::Prediction> kept;
  std::function<double(const std::vector<double> &, const std::vector<double> &)> misfit_of;
  unsigned int evaluations = 0;
  unsigned int failures = 0;
  std::string failure;
};
} // namespace Continua

#endif
