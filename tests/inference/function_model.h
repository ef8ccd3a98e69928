#ifndef continua_tests_inference_function_model_h
#define continua_tests_inference_function_model_h

#include <continua/inference/fit_model.h>

#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

/// A model given by a function. What it throws is a failure.
class FunctionModel : public Continua::FitModel
{
public:
  using Function = std::function<std::vector<double>(const std::vector<double> &)>;
  explicit FunctionModel(Function function) : function(std::move(function)) {}
  std::vector<Prediction> predict(const std::vector<std::vector<double>> &sets) override
  {
    ++n_calls;
    std::vector<Prediction> predictions;
    for (const std::vector<double> &set : sets)
    {
      ++n_sets;
      try
      {
        predictions.push_back({function(set), ""});
      }
      catch (const std::exception &error)
      {
        predictions.push_back({{}, error.what()});
      }
    }
    return predictions;
  }
  unsigned int n_calls = 0;
  unsigned int n_sets = 0;

private:
  Function function;
};

#endif
