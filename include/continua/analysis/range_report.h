#ifndef continua_analysis_range_report_h
#define continua_analysis_range_report_h

#include <continua/analysis/run.h>

#include <array>
#include <string>

namespace Continua
{
/// Whether a quantity is one that RangeReport adds: largest values over a mesh do not converge at
/// corners.
bool is_of_the_range(const std::string &name);

/**
 * How far a run leaves the range in which its equations hold: the largest values of its states, and
 * a warning where one is above a bound. doc/range.md explains each, and has the errors that the
 * bounds are taken from.
 */
template <int dim>
class RangeReport
{
public:
  /// @name Bounds of a run with small deformation
  /// Above each of the first four an error passes 2 %: the distension of a tube; the deflection of
  /// a cantilever; the speed of the wave of a tube whose radius grows; the speed of a wave without
  /// the terms of convection. Above the fifth the deflection of the beam behind the cylinder does.
  /// @{
  static constexpr double largest_strain = 0.008;
  static constexpr double largest_rotation = 0.2; ///< [rad]
  static constexpr double largest_displacement_over_radius = 0.01;
  static constexpr double largest_speed_over_wave_speed = 0.02;
  static constexpr double largest_change_of_load = 0.08;
  /// With convection, of a liquid that is compressible: at it the pressure behind a shock that the
  /// cells do not resolve is 0.07 % too high.
  static constexpr double largest_shock_strength = 0.1;
  /// @}

  explicit RangeReport(Run<dim> &run);
  RangeReport(const RangeReport &) = delete;
  RangeReport &operator=(const RangeReport &) = delete;

  /// A run in time looks at the state after so many steps, again and again, and at the last one: a
  /// look costs a tenth of a step, with the cheapest schemes a half.
  static constexpr unsigned int every_n_steps = 10;
  /// Of the pressure wave [m/s]; 0 if the body is no tube with a wall.
  void set_tube_speed(double speed) { tube_speed = speed; }
  /// Looks at the present state at `time` [s]. Collective.
  void take(double time);
  /// Adds to the summary, and warns.
  void finish();
  static void name_quantities(const Case<dim> &input, QuantityNames &names);

  void save(ArchiveWriter &archive) const;
  void load(const ArchiveReader &archive);

private:
  struct Largest
  {
    double value = 0., time = 0.;
    void take(double candidate, double at_time);
  };

  Run<dim> &run;
  bool has_solids = false, has_liquids = false;
  double tube_speed = 0.; ///< [m/s]
  Largest strain, rotation, wall_displacement, displacement_over_radius, speed, change_of_load,
      compression_of_mesh;
  /// In the order of the archive.
  const std::array<Largest *, 7> all = {{&strain, &rotation, &wall_displacement,
                                         &displacement_over_radius, &speed, &change_of_load,
                                         &compression_of_mesh}};

  /// Calls add(name, value, time [s], unit) for all that the run states.
  template <typename Add>
  void for_all(const Add &add) const;
  /// Sets them in the summary, as far as they are known.
  void state_values();
  /// The wave to which the speed of the liquid compares [m/s]; 0 if there is none, or none whose
  /// speed is known.
  double wave_speed() const;
  /// What the walls' rotation changes of the stream's load, over the load that deforms the solids.
  double present_change_of_load(const MotionExtremes &extremes) const;
};
} // namespace Continua

#endif
