#ifndef continua_theory_wave_model_h
#define continua_theory_wave_model_h

#include <continua/theory/wave_source.h>

#include <string>
#include <vector>

namespace Continua
{
/// What wave theory says at one station over time.
struct WaveHistory
{
  std::vector<double> pressure;          ///< mean over the liquid's section [Pa]
  std::vector<double> axis_pressure;     ///< [Pa]
  std::vector<double> flow_rate;         ///< [m^3/s]
  std::vector<double> wall_distension;   ///< change of the inner diameter [m]
  std::vector<double> wall_shear_stress; ///< of the liquid on the wall, positive downstream [Pa]
  std::vector<double> hoop_stress;       ///< mean over the wall's section [Pa]
  /// Why the theory has no values from some time on, which are NaN then; empty: it has all.
  std::string end;
};

/// A theory of the waves of a tube, or of one that divides, from rest on. It stands beside a run as
/// a source of the WaveReport.
class WaveModel
{
public:
  virtual ~WaveModel() = default;

  virtual WaveSource source() const = 0;
  /// The histories at the stations z [m] at these times [s], which do not fall and are not above
  /// the end of the load; of the tube itself (0) or of a branch, counted from 1, each before those
  /// behind it. z and flow rates count from the end with the load. Throws std::invalid_argument.
  virtual std::vector<WaveHistory> histories(const std::vector<double> &stations,
                                             const std::vector<double> &times,
                                             unsigned int branch) const = 0;
};
} // namespace Continua

#endif
