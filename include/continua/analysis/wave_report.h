#ifndef continua_analysis_wave_report_h
#define continua_analysis_wave_report_h

#include <continua/base/summary.h>
#include <continua/signal/wave_analysis.h>

#include <set>
#include <string>
#include <vector>

namespace Continua
{
/// What is recorded of a wave, and where.
struct WaveStations
{
  std::string name;                ///< of the probe
  std::vector<double> positions;   ///< z [m], increasing
  std::vector<std::string> fields; ///< "pressure", "flow rate", ...
  std::vector<std::string> units;  ///< of the fields
  /// Of each station, rho c/A [Pa s/m^3]; splits pressure and flow rate into waves.
  std::vector<double> impedances;
  double direction = 1.; ///< in which the first pulse travels along z: +1 or -1
};

/**
 * A wave at stations along a tube, as it was simulated, as theory has it and as it was measured, as
 * far as each is there: side by side with their differences in a table, and in the summary what
 * they say of the wave and how far they are from each other.
 */
class WaveReport
{
public:
  /// By station, by field, by time; SI.
  using Histories = std::vector<std::vector<std::vector<double>>>;

  /// What the user should know.
  struct Notes
  {
    std::vector<std::string>
        lines; ///< why a speed or the attenuation is absent, or a record left out
    std::vector<std::string> details; ///< which stations are left out, and why
  };

  WaveReport(const WaveStations &stations, const std::vector<double> &times);

  enum class Source
  {
    simulated,
    theory,
    measured
  };
  /// A measured value that is NaN (there is none at this station, of this field or at this time) is
  /// left out of all that follows.
  void set(Source source, const Histories &histories);

  /**
   * Columns "NAME 0.1 m: pressure, simulated [Pa]", then theory, measured and the differences
   * between simulated (or else theory) and the others; where pressure and flow rate are recorded
   * also "forward wave" and "backward wave". Throws RunError when the disk refuses.
   */
  void write(const std::string &file) const;

  /**
   * Of each source (theory's and measured quantities are called "theoretical ...", "measured ..."):
   * `wave speed` (by the peak of the first pulse), `wave speed at half height`, `wave speed of the
   * foot`, `wave speed by phase`, `attenuation`; at each station `first pulse time`, `first pulse
   * height`, `half height time`, `foot time`, and where flow rates are recorded `reflection
   * coefficient`, `reflected pulse time`, `reflected pulse height` (the largest
   * backward wave, if it is above a tenth of the first pulse).
   * Between simulation and theory, and between measurement and what is simulated (else theory):
   * `largest difference of FIELD` (relative to the largest value of the field), and relative, over
   * the stations that have both, `largest difference of first pulse time`, `... height`, `largest
   * difference of reflected pulse time`, `... height`; with "from measurement" added for the
   * latter. What the record cannot carry is absent, with the reason in the summary. Returns what
   * the user should know.
   */
  Notes add_quantities(Summary &summary) const;
  /// Pulses, speeds and reflections are those until this time [s] only: the first one of several
  /// beats. The table has all times.
  void set_end_of_first_beat(double end_time);
  /// Or they are those of the beat between these two times [s]: what pressure and flow rate are
  /// more than at its start.
  void set_beat(double begin_time, double end_time);
  /// The names of what add_quantities() adds when the `sources` are there.
  static void name_quantities(const WaveStations &stations,
                              const std::set<Source> &sources,
                              QuantityNames &names);

private:
  /// What one source says at one station.
  struct Pulse
  {
    double time, height, half_time, foot_time, reflection, reflected_time, reflected_height;
  };
  struct Data
  {
    bool present = false;
    Histories histories;
  };
  WaveStations stations;
  std::vector<double> times;
  Data sources[3];
  /// The times in which pulses are looked for: the first one, and their number.
  std::size_t first_analysed = 0, n_analysed;

  const Data &data(Source source) const { return sources[static_cast<int>(source)]; }
  int field(const std::string &name) const;
  std::string station_name(unsigned int station) const;
  /// "0.1 m: 0 s to 0.01 s": stations whose pressure is there for a part of the run only.
  std::string records_in_part(const Histories &histories) const;
  std::vector<Pulse> analyse(Source source, Summary &summary, Notes &notes) const;
  /// Which stations have no pulse, and why; `used`: those that were analysed.
  std::string places_without_pulse(const std::vector<unsigned int> &used,
                                   const WaveAnalysis &wave) const;
  void compare(Source a,
               Source b,
               const std::vector<std::vector<Pulse>> &pulses,
               const std::string &suffix,
               Summary &summary) const;
};
} // namespace Continua

#endif
