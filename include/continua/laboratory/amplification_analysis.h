#ifndef continua_laboratory_amplification_analysis_h
#define continua_laboratory_amplification_analysis_h

#include <continua/analysis/analysis.h>
#include <continua/base/expected_value.h>
#include <continua/base/quantity_names.h>
#include <continua/laboratory/amplification_parameters.h>

namespace Continua
{
/**
 * What schemes in time do to waves of a bar: amplification.csv has for each Courant number and
 * number of cells in a wavelength the magnitude of the amplification factor and the ratio of the
 * numerical to the exact speed, by closed formulas and as measured in runs (figures 3.8 and
 * 3.10 of the thesis). The summary has what each scheme is like over all of them.
 */
class AmplificationAnalysis : public Analysis
{
public:
  /// Throws InputError.
  explicit AmplificationAnalysis(const AnalysisInput &input);

  QuantityNames quantity_names() const override { return quantities; }
  std::vector<std::string> outline() const override;

private:
  AmplificationParameters parameters;
  std::vector<ExpectedValue> expected;
  QuantityNames quantities; ///< that the analysis can state

  /// Every rank does it, and rank 0 writes.
  void compute(const OutputDirectory &directory, Log &log, Summary &summary) override;
  /// The table and the quantities.
  void compute_waves(const OutputDirectory &directory, Log &log, Summary &summary) const;
};
} // namespace Continua

#endif
