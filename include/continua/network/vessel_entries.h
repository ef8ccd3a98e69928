#ifndef continua_network_vessel_entries_h
#define continua_network_vessel_entries_h

#include <continua/base/parameter_section.h>

#include <continua/network/wall_material.h>

#include <functional>
#include <string>
#include <vector>

namespace Continua
{
/// A vessel as a file describes it. Radius and thickness are linear between its ends.
struct VesselEntries
{
  std::string name, from, to;                            ///< its nodes
  double length = 0.;                                    ///< [m]
  double radius_at_start = 0., radius_at_end = 0.;       ///< inner ones [m]
  double thickness_at_start = 0., thickness_at_end = 0.; ///< of the wall [m]
  double youngs_modulus = 0.;                            ///< [Pa]; 0: that of the material
  std::string material;                                  ///< of the section Materials; or none
  WallMaterial wall;                                     ///< of it, set by NetworkParameters
  double rise = 0.; ///< how much higher its end is than its start [m]
  /// Throws the InputError of an entry ("Length", "To", ...) with problem and remedy.
  std::function<void(const std::string &, const std::string &, const std::string &)> refuse;

  double radius(double z) const;    ///< [m] at z [m]
  double thickness(double z) const; ///< [m]

  /// Declares and reads one subsection of Vessels, called after the vessel. Throws InputError.
  static VesselEntries read(ParameterSection section);
  /// The rows of a csv file with the columns name, from, to, length, radius at start, radius at
  /// end, wall thickness at start, wall thickness at end, Young's modulus and, if there is one,
  /// rise. Throws InputError.
  static std::vector<VesselEntries> read_table(const std::string &file);
};
} // namespace Continua

#endif
