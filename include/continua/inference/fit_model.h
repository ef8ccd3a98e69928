#ifndef continua_inference_fit_model_h
#define continua_inference_fit_model_h

#include <string>
#include <vector>

namespace Continua
{
/// parameters -> predicted values of all records, one after another.
class FitModel
{
public:
  struct Prediction
  {
    std::vector<double> values; ///< [unit of each record]; empty after a failure
    std::string failure;        ///< why there are no values; empty: there are
  };
  virtual ~FitModel() = default;
  /// Of several sets of parameters, [unit] each, in the order of the FitParameters; may compute
  /// them side by side. One prediction a set.
  virtual std::vector<Prediction> predict(const std::vector<std::vector<double>> &sets) = 0;
  /// Analytic d prediction / d parameter [unit of the record / unit of the parameter], one vector a
  /// parameter, if it is cheap. False where there is none: differences are taken then.
  virtual bool derivatives(const std::vector<double> &set,
                           std::vector<std::vector<double>> &by_parameter);
};
} // namespace Continua

#endif
