#ifndef continua_inference_model_derivatives_h
#define continua_inference_model_derivatives_h

#include <continua/inference/evaluated_model.h>
#include <continua/inference/fit_parameter.h>

#include <string>
#include <vector>

namespace Continua
{
/// d prediction / d coordinate.
struct ModelDerivatives
{
  std::vector<std::vector<double>> columns; ///< by parameter; empty if it was not asked for
  std::string failure; ///< which derivative cannot be taken, and why; empty: there are all
};

/**
 * Derivatives of a model at a set: its analytic ones if it has them, else central differences, all
 * sets in one call. At a bound three points within the bounds take their place; where the model
 * fails three points on either side, with this distance and a tenth of it.
 * `step`: FitOptions::difference_step.
 */
ModelDerivatives model_derivatives(const std::vector<FitParameter> &parameters,
                                   EvaluatedModel &model,
                                   const std::vector<double> &set,
                                   const std::vector<unsigned int> &of,
                                   double step);
} // namespace Continua

#endif
