#ifndef continua_mesh_cylinder_sector_h
#define continua_mesh_cylinder_sector_h

#include <deal.II/base/point.h>

#include <array>

namespace Continua
{
/**
 * A part of the plane between a circle and one side of a square around it, filled with straight
 * lines from the circle to the side.
 *
 * A point is told by its place (s, v): v from 0 to 1 tells the line, counter-clockwise; s is 0 on
 * the circle and 1 on the side, and grows in proportion to the length of the line. The ends of the
 * lines divide the arc and the part of the side equally. Where `is_beam` is set, the lines are at
 * right angles to the side instead, as the fibres of a beam are: the arc is between the same two
 * lines as the part of the side, and `angles` has no meaning.
 */
struct CylinderSector
{
  dealii::Point<2> centre;  ///< of the circle and of the square [m]
  double radius = 1.;       ///< of the circle [m]
  double half_side = 2.;    ///< of the square [m]
  unsigned int quarter = 0; ///< the side lies towards x (0), y (1), -x (2) or -y (3)
  /// The ends of the arc for v = 0 and v = 1, counted from the direction of `quarter` [rad].
  std::array<double, 2> angles = {{0., 0.}};
  /// The ends of the part of the side for v = 0 and v = 1, counted from its middle [m].
  std::array<double, 2> sides = {{0., 0.}};
  bool is_beam = false;

  dealii::Point<2> point(double s, double v) const; ///< the point [m] at a place
  /// The inverse of `point`; a little beyond the sector, too: v from -1/2 to 3/2.
  dealii::Point<2> place(const dealii::Point<2> &point) const;
};
} // namespace Continua

#endif
