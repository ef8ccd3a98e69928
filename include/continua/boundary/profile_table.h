#ifndef continua_boundary_profile_table_h
#define continua_boundary_profile_table_h

#include <continua/base/csv_table.h>
#include <continua/base/interpolant.h>

#include <string>

namespace Continua
{
/**
 * A velocity over a section that was measured or computed elsewhere: a csv file with the distance
 * from the centre and the velocity along the axis, "r [mm], U [m/s]". Of a channel the distances
 * may be those on both sides of its middle, negative on one side; else the profile is the same
 * there. Only the shape counts: a flow rate scales it.
 */
class ProfileTable
{
public:
  /// `column`: the name of the velocity's column; empty where there is but one. Throws InputError.
  ProfileTable(const std::string &file, Interpolant::Kind kind, const std::string &column);

  /// Throws InputError, with the line of the table, unless it reaches from the centre (or from the
  /// other side of a channel) to a radius [m], or if nothing flows through this section.
  void check(double radius, bool is_channel) const;
  /// The velocity at a distance from the centre [m] over its mean over the section up to `radius`.
  double shape(double distance, double radius, bool is_channel) const;

private:
  CsvTable table;
  Interpolant velocity;
  std::vector<double> distances; ///< [m]

  bool has_two_sides() const { return distances.front() < 0.; }
  /// Of a section up to `radius` [m/s].
  double mean(double radius, bool is_channel) const;
};
} // namespace Continua

#endif
