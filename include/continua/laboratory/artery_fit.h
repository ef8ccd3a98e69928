#ifndef continua_laboratory_artery_fit_h
#define continua_laboratory_artery_fit_h

#include <continua/analysis/analysis.h>
#include <continua/base/expected_value.h>
#include <continua/base/quantity_names.h>
#include <continua/inference/fit_result.h>
#include <continua/laboratory/artery_fit_parameters.h>

#include <vector>

namespace Continua
{
/**
 * `Analysis = artery fit`: numbers of the layers of an artery from an inflation-extension test
 * (ArteryModel), with standard errors and correlations (correlation.csv), beside the measured
 * values (fit-inflation.csv), and the layers as materials that a parameter file can have
 * (materials.prm).
 */
class ArteryFit : public Analysis
{
public:
  /// Throws InputError.
  explicit ArteryFit(const AnalysisInput &input);

private:
  ArteryFitParameters parameters;
  std::vector<ExpectedValue> expected;
  QuantityNames quantities; ///< that the analysis can state

  /// Every rank does it, and rank 0 writes.
  void compute(const OutputDirectory &directory, Log &log, Summary &summary) override;
  void check_rows(const ParameterSection &section) const;
  void write_rows(const std::string &file, const FitResult &result) const;
  /// The layers with the numbers found; the radii of the tube stand in comments.
  std::string materials_text(const FitResult &result, const LoadedTube &tube) const;
};
} // namespace Continua

#endif
