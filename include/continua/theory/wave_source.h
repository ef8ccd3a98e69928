#ifndef continua_theory_wave_source_h
#define continua_theory_wave_source_h

#include <string>
#include <vector>

namespace Continua
{
/// Who says what a wave is, and what this is called in tables and summaries.
struct WaveSource
{
  std::string name;         ///< of its curves: "simulated", "theory", ...
  std::string prefix;       ///< of its quantities: "theoretical wave speed"
  std::string from;         ///< behind the names of the differences from it: " from measurement"
  bool is_measured = false; ///< may have gaps, and is not divided into waves

  static WaveSource simulated() { return {"simulated", "", ""}; }
  /// The differences of a run from it have had no addition since before there were other theories.
  static WaveSource linear_theory() { return {"theory", "theoretical ", ""}; }
  static WaveSource nonlinear_theory()
  {
    return {"nonlinear theory", "nonlinear theoretical ", " from nonlinear theory"};
  }
  static WaveSource measured() { return {"measured", "measured ", " from measurement", true}; }
  /// In the order of tables.
  static std::vector<WaveSource> all()
  {
    return {simulated(), linear_theory(), nonlinear_theory(), measured()};
  }
};
} // namespace Continua

#endif
