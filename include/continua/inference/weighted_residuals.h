#ifndef continua_inference_weighted_residuals_h
#define continua_inference_weighted_residuals_h

#include <continua/inference/data_record.h>
#include <continua/inference/fit_parameter.h>
#include <continua/inference/whitening.h>

#include <vector>

namespace Continua
{
/// The rows of least squares: residuals of all records made white by their noise, then one row for
/// each prior of a parameter that is not held. All in standard deviations [1].
class WeightedResiduals
{
public:
  /// Standard deviations of the records must be known.
  WeightedResiduals(const std::vector<FitParameter> &parameters,
                    const std::vector<DataRecord> &records);
  /// Predicted less measured.
  std::vector<double> rows(const std::vector<double> &set,
                           const std::vector<double> &prediction) const;
  /// Rows of d prediction / d coordinate of one parameter, with its prior.
  std::vector<double> column(unsigned int parameter, const std::vector<double> &derivative) const;
  /// The same of a derivative that is white already.
  std::vector<double> with_priors(unsigned int parameter, std::vector<double> whitened) const;
  /// Sum of the squares of the rows.
  double misfit(const std::vector<double> &set, const std::vector<double> &prediction) const;
  /// Values of all records [unit of each] made white, without priors.
  std::vector<double> whiten(const std::vector<double> &values) const;
  std::size_t n_values() const { return n_data; }
  std::size_t n_rows() const { return n_data + priors.size(); }

private:
  const std::vector<FitParameter> &parameters;
  const std::vector<DataRecord> &records;
  std::vector<Whitening> whitenings;
  std::vector<unsigned int> priors; ///< parameters that have one
  std::size_t n_data = 0;
};
} // namespace Continua

#endif
