#ifndef continua_inference_evaluation_h
#define continua_inference_evaluation_h

#include <continua/inference/fit_model.h>

#include <functional>
#include <string>
#include <vector>

namespace Continua
{
/// One evaluation of a FitModel.
struct Evaluation
{
  std::vector<double> set;         ///< [unit of each parameter]
  FitModel::Prediction prediction; ///< or its failure
  double misfit; ///< chi-square with the present noise [1]; NaN after a failure, and without data
  std::string purpose; ///< "start", "step", "difference", "profile"
};
/// Called after each evaluation that the model made, in the order in which it made them.
using EvaluationObserver = std::function<void(const Evaluation &)>;
} // namespace Continua

#endif
