#ifndef continua_analysis_wave_report_h
#define continua_analysis_wave_report_h

#include <continua/base/summary.h>
#include <continua/signal/wave_analysis.h>
#include <continua/theory/wave_source.h>

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
 * A wave at stations along a tube by several sources, such as a run, theories of it and a
 * measurement: side by side with their differences in a table, and in the summary what they say of
 * the wave and how far the first one is from each of the others.
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

  /// The sources stand in the order in which they come. The first one is compared with the others.
  /// A value that is NaN (there is none at this station, of this field or at this time) is left out
  /// of all that follows. But of a field whose values end before the last time (a theory that has
  /// no state any more; not a measurement) the largest difference is absent.
  void add(const WaveSource &source, const Histories &histories);

  /**
   * Columns "NAME 0.1 m: pressure, simulated [Pa]", then the other sources and the differences
   * between the first source and the others; where pressure and flow rate are recorded also
   * "forward wave" and "backward wave". Throws RunError when the disk refuses.
   */
  void write(const std::string &file) const;

  /**
   * Of each source (quantities begin with its prefix, such as "theoretical ..."):
   * `wave speed` (by the peak of the first pulse), `wave speed at half height`, `wave speed of the
   * foot`, `wave speed by phase`, `attenuation`; at each station `first pulse time`, `first pulse
   * height`, `half height time`, `foot time`, and where flow rates are recorded `reflection
   * coefficient`, `reflected pulse time`, `reflected pulse height` (the largest
   * backward wave, if it is above a tenth of the first pulse).
   * Between the first source and each other one: `largest difference of FIELD` (relative to the
   * largest value of the field of the other one), and relative, over the stations that have both,
   * `largest difference of first pulse time`, `... height`, `largest difference of reflected pulse
   * time`, `... height`, with what the other source adds, such as "from measurement". What the
   * record cannot carry is absent, with the reason in the summary. Returns what the user should
   * know.
   */
  Notes add_quantities(Summary &summary);
  /// Pulses, speeds and reflections are those until this time [s] only: the first one of several
  /// beats. The table has all times.
  void set_end_of_first_beat(double end_time);
  /// Or they are those of the beat between these two times [s]: what pressure and flow rate are
  /// more than at its start.
  void set_beat(double begin_time, double end_time);
  /// The names of what add_quantities() adds when the `sources` are there, in their order.
  static void name_quantities(const WaveStations &stations,
                              const std::vector<WaveSource> &sources,
                              QuantityNames &names);

private:
  /// What one source says at one station.
  struct Pulse
  {
    double time, height, half_time, foot_time, reflection, reflected_time, reflected_height;
  };
  struct Data
  {
    WaveSource source;
    Histories histories;
    std::vector<Pulse> pulses; ///< by station; none without pressures
  };
  WaveStations stations;
  std::vector<double> times;
  std::vector<Data> sources;
  /// The times in which pulses are looked for: the first one, and their number.
  std::size_t first_analysed = 0, n_analysed;

  int field(const std::string &name) const;
  std::string station_name(unsigned int station) const;
  /// "0.1 m: 0 s to 0.01 s": stations whose pressure is there for a part of the run only.
  std::string records_in_part(const Histories &histories) const;
  std::vector<Pulse> analyse(const Data &data, Summary &summary, Notes &notes) const;
  /// Which stations have no pulse, and why; `used`: those that were analysed.
  std::string places_without_pulse(const std::vector<unsigned int> &used,
                                   const WaveAnalysis &wave) const;
  void compare(const Data &first, const Data &second, Summary &summary) const;
};
} // namespace Continua

#endif
