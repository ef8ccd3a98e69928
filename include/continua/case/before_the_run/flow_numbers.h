#ifndef continua_case_before_the_run_flow_numbers_h
#define continua_case_before_the_run_flow_numbers_h

#include <continua/case/before_the_run/preflight_entry.h>

#include <string>
#include <vector>

namespace Continua
{
/// What FlowNumbers is computed from.
struct FlowNumbersInput
{
  /// What the liquid flows through, which decides when it becomes turbulent.
  enum class Duct
  {
    pipe,    ///< walls around, or a ring
    channel, ///< two plane walls
    none     ///< no wall at the section
  };
  /// Where the velocity is prescribed that gives the largest Reynolds number; empty if pressures
  /// and other loads alone drive the flow.
  std::string boundary;
  bool flows_in = true;        ///< through that boundary; false: the boundary moves along itself
  double mean_speed = 0.;      ///< [m/s] over that boundary, the largest of the run
  double largest_speed = 0.;   ///< [m/s] on it
  double density = 0.;         ///< [kg/m^3] of the liquid there
  double viscosity = 0.;       ///< [Pa s], at zero rate of shear; 0: inviscid
  bool has_flow_curve = false; ///< whether the viscosity depends on the rate of shear
  Duct duct = Duct::none;
  /// [m]: of a channel its gap; of a pipe four times the area over the wetted perimeter; where
  /// there is no wall the extent of the section.
  double width = 0.;
  double largest_cell = 0.; ///< [m], longest extent of a cell along an axis, for degree 2
  /// A developed flow through a straight duct with rigid walls: it does not change along the cells,
  /// and `largest_cell` is the longest extent across the flow.
  bool is_developed = false;
  double shortest_cell = 0.;        ///< [m], the shortest of these longest extents
  double time_step = 0.;            ///< [s]; 0: a steady flow
  double frequency = 0.;            ///< [Hz] of the load; 0: it does not vary
  bool convects_explicitly = false; ///< so that long steps are unstable
  double wave_speed = 0.;           ///< [m/s]; 0: there are no waves
  std::string wave;                 ///< which wave that is
  bool has_absorbing_end = false;
};

/**
 * The numbers of a flow with convection as the parameter file has them, before the run:
 * doc/preflight.md explains each, and the limits below. Entrance lengths are those of F. Durst, S.
 * Ray, B. Uensal, O. A. Bayoumi, J. Fluids Eng. 127 (2005) 1154-1160.
 */
class FlowNumbers
{
public:
  /// @name Limits at which a warning is given
  /// @{
  static constexpr double largest_cell_reynolds_number = 50.;
  static constexpr double turbulence_in_a_pipe = 2300.;    ///< by mean speed and diameter
  static constexpr double turbulence_in_a_channel = 1300.; ///< by mean speed and gap
  static constexpr double largest_mach_number = 0.1;       ///< at absorbing ends
  static constexpr double largest_courant_number = 5.;
  static constexpr double largest_explicit_courant_number = 0.2;
  /// @}

  explicit FlowNumbers(const FlowNumbersInput &input);

  const std::vector<PreflightEntry> &entries() const { return list; }
  const std::vector<std::string> &warnings() const { return warning_list; }
  /// The value of that entry; NaN if there is none.
  double value(const std::string &name) const;
  /// One line for the screen.
  std::string headline() const;

  /// @name For any speed [m/s], such as the largest one that a run has met
  /// @{
  double reynolds_number(double speed) const; ///< 0 of an inviscid liquid
  double cell_reynolds_number(double speed) const;
  double courant_number(double speed, double time_step) const; ///< time step [s]
  /// @}

private:
  const FlowNumbersInput input;
  std::vector<PreflightEntry> list;
  std::vector<std::string> warning_list;

  void add(const std::string &name,
           double value,
           const std::string &unit,
           const std::string &remark = "");
  void report_reynolds_numbers();
  void report_entrance(double reynolds);
  void report_time();
  void report_waves();
};
} // namespace Continua

#endif
