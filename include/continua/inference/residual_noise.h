#ifndef continua_inference_residual_noise_h
#define continua_inference_residual_noise_h

#include <continua/inference/data_record.h>
#include <continua/inference/fit_options.h>

#include <optional>
#include <vector>

namespace Continua
{
/// The noise of records as their residuals show it.
class ResidualNoise
{
public:
  ResidualNoise(const std::vector<DataRecord> &records, const FitOptions &options);
  /// Records with a first value where the standard deviation is unknown: the scatter of the values.
  std::vector<DataRecord> first_guess() const;
  /// Records with the noise that `residuals` [unit], by record, show. `weighted`: records with the
  /// noise of the fit that left these residuals; `columns`: its derivatives by the free parameters,
  /// whitened, with the rows of priors. The order of autoregressive models stays as it is after the
  /// second call.
  std::vector<DataRecord> estimate(const std::vector<DataRecord> &weighted,
                                   const std::vector<std::vector<double>> &residuals,
                                   const std::vector<std::vector<double>> &columns);
  bool has_something_to_estimate() const;
  bool deviation_is_unknown(unsigned int record) const;
  /// Autoregressive coefficients of a record that come from its residuals.
  unsigned int n_fitted_coefficients(unsigned int record) const;

private:
  bool finds_correlation(unsigned int record) const;
  unsigned int order_of(unsigned int record, const std::vector<double> &residuals) const;

  std::vector<DataRecord> given;
  const FitOptions &options;
  std::vector<std::optional<unsigned int>> orders;
  unsigned int n_estimates = 0;
};
} // namespace Continua

#endif
