#ifndef continua_case_before_the_run_preflight_report_h
#define continua_case_before_the_run_preflight_report_h

#include <continua/case/before_the_run/preflight_entry.h>
#include <continua/case/before_the_run/preflight_input.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * What linear theory says of a fluid-structure run before its first step: speeds, lengths and times
 * of its waves, how mesh and step resolve them, and what the scheme takes from them.
 * doc/preflight.md explains every entry with its formula, and the limits below.
 */
class PreflightReport
{
public:
  using Entry = PreflightEntry;

  /// @name Limits at which a warning is given
  /// @{
  static constexpr double least_nodes_per_wavelength = 20.;
  static constexpr double least_steps_per_period = 40.;
  static constexpr double largest_loss = 0.01;         ///< of the amplitude over the run
  static constexpr double largest_layer_cell = 1.;     ///< thickness over that of Stokes's layer
  static constexpr double largest_clamped_cell = 0.75; ///< axial extent over sqrt(R h)
  /// @}

  explicit PreflightReport(const PreflightInput &input);

  const std::vector<Entry> &entries() const { return list; }
  const std::vector<std::string> &warnings() const { return warning_list; }
  /// The value of that entry; NaN if there is none.
  double value(const std::string &name) const;
  /// One line for the screen, for example "Pre-flight: load of 20.5 Hz, tube wave 2.555 m/s, 174.6
  /// ms to the far end; more in log.txt".
  std::string headline() const;

private:
  const PreflightInput input;
  std::vector<Entry> list;
  std::vector<std::string> warning_list;
  double frequency = 0.; ///< [Hz] at which the waves are looked at

  void add(const std::string &name,
           double value,
           const std::string &unit,
           const std::string &remark = "");
  double reference_angular_frequency() const;
  void report_regions();
  void report_tube();
  void report_tube_mesh(double wavelength);
  void report_ends(double speed);
  void report_outlet(const PreflightInput::End &end, const std::string &which);
  void report_body_mesh();
  void report_time();
  void report_stiffest_mode();
};
} // namespace Continua

#endif
