#ifndef continua_mesh_curved_vessel_geometry_h
#define continua_mesh_curved_vessel_geometry_h

#include <continua/mesh/tube_geometry.h>

namespace Continua
{
/**
 * `curved vessel`: a round vessel full of fluid along a line in space, from a table of the line's
 * points with the inner radius and the wall's thickness there. Regions, boundaries and mesh are
 * those of a TubeGeometry, whose axis comes to lie on the Centreline; sections are plane, round and
 * across the line.
 */
class CurvedVesselGeometry : public TubeGeometry<3>
{
public:
  struct Parameters : TubeGeometry<3>::Parameters
  {
    /**
     * Throws InputError with file, row and remedy, also for a line that goes back, a bend in which
     * sections would meet (outer radius times curvature above `largest_bend`) and parts of the
     * vessel that lie in each other.
     */
    static Parameters read(ParameterSection geometry, ParameterSection mesh);
  };
  /// Of the outer radius over the radius of the bend: cells at the inside of the bend are shorter
  /// than those on the axis by one minus this.
  static constexpr double largest_bend = 0.9;

  explicit CurvedVesselGeometry(const Parameters &parameters) : TubeGeometry<3>(parameters) {}
};
} // namespace Continua

#endif
