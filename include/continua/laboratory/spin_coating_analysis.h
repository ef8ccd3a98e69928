#ifndef continua_laboratory_spin_coating_analysis_h
#define continua_laboratory_spin_coating_analysis_h

#include <continua/analysis/analysis.h>
#include <continua/base/log.h>
#include <continua/base/output_directory.h>
#include <continua/vessel/spin_coating.h>
#include <continua/vessel/tube_law.h>

namespace Continua
{
/**
 * How the tube of the section Geometry is made by spin coating: spin-coating.csv has what the two
 * motors are to do along the rod (figures A.4, A.6 and A.7 of the thesis), the summary the volume
 * of solution, the time it takes and the ranges of the speeds. There is neither a mesh nor a
 * material.
 */
class SpinCoatingAnalysis : public Analysis
{
public:
  /// Throws InputError.
  explicit SpinCoatingAnalysis(const AnalysisInput &input);

  QuantityNames quantity_names() const override { return quantities; }

private:
  TubeLaw law;
  SpinCoating coating;
  std::vector<ExpectedValue> expected;
  QuantityNames quantities; ///< that the analysis can state

  /// Rank 0 does it alone.
  void compute(const OutputDirectory &directory, Log &log, Summary &summary) override;
};
} // namespace Continua

#endif
