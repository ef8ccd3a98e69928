#ifndef continua_inference_model_bias_h
#define continua_inference_model_bias_h

#include <continua/inference/fit_result.h>

#include <vector>

namespace Continua
{
/// By how much the estimates are off because the model is another one than nature.
struct ModelBias
{
  std::vector<double> bias; ///< estimate less truth [unit]; NaN if held or at a bound
  std::vector<double> over_standard_error; ///< bias over the standard error [1]
  /// Root of the part of chi-square that the difference adds and no parameter takes up [1]: what a
  /// look at the residuals could find.
  double unexplained;
};

/**
 * First-order bias (J^T W J)^-1 J^T W (other - model) of the parameters of a fit whose data follow
 * `other`, with the J and W of the fit, priors included. Both are predictions of all records for
 * the estimates [unit of each record]. A larger noise does not cover a bias. Throws
 * std::invalid_argument for predictions of another length, and if no parameter is free.
 */
ModelBias model_bias(const std::vector<FitParameter> &parameters,
                     const FitResult &fit,
                     const std::vector<DataRecord> &records,
                     const std::vector<double> &model,
                     const std::vector<double> &other);
} // namespace Continua

#endif
