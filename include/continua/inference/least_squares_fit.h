#ifndef continua_inference_least_squares_fit_h
#define continua_inference_least_squares_fit_h

#include <continua/inference/evaluated_model.h>
#include <continua/inference/fit_options.h>
#include <continua/inference/fit_result.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * Finds the parameters of a model from records of data by weighted nonlinear least squares, with
 * errors that follow from the noise. The residuals of each record are made white by its noise
 * (noise_model.h), priors are further rows, and GSL's trust region makes the steps
 * (bounded_minimiser.h). Noise whose standard deviation is unknown, or that is correlated though it
 * was given as white, is estimated from the residuals, and the fit repeated until it no longer
 * changes. See doc/identification-statistics.md.
 */
class LeastSquaresFit
{
public:
  /// Throws std::invalid_argument for parameters or records that are wrong (fit_parameter.h,
  /// data_record.h), for no parameter that is not held, and for fewer values and priors than
  /// parameters, or as many if a standard deviation is unknown.
  LeastSquaresFit(std::vector<FitParameter> parameters,
                  std::vector<DataRecord> records,
                  FitModel &model,
                  FitOptions options = {});
  ~LeastSquaresFit();
  /// Throws RunError if the model fails at all starts.
  FitResult solve();

private:
  std::vector<FitParameter> parameters;
  std::vector<DataRecord> records;
  FitOptions options;
  EvaluatedModel model;
};
} // namespace Continua

#endif
