#ifndef continua_mesh_bifurcation_shape_h
#define continua_mesh_bifurcation_shape_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * The shape of three tubes, filled and with a wall, that meet in one point, their axes in a plane
 * z = const: where a place of a tube lies in space, and the inverse.
 *
 * A place of a tube is (a, y, z): a [m] is the distance along the axis from the point where the
 * tubes meet; y and z are the scaled coordinates of TubeCrossSection, y along the normal of the
 * axis in the plane (a quarter of a turn counter-clockwise from the axis as it leaves the point), z
 * across the plane. A distance from the axis of 1 is the wall's inner surface, of 2 its outer one.
 *
 * From a = reach() on a tube is straight and round. At a = 0 it ends in two half-surfaces, y > 0 on
 * the one that it shares with its neighbour counter-clockwise, y < 0 on the other. A half-surface
 * is plane. It is spanned by the z direction and a direction in the plane between the two axes, and
 * its lines of constant distance are halves of ellipses. Between the circle at a = reach() and the
 * half-surfaces each line of constant (y, z) is a cubic curve (Hermite's). On the surfaces of the
 * wall it leaves the half-surface at a right angle, or along the ellipse, so that the surfaces of
 * two neighbours have the same tangent planes there: they are smooth all around, the corner between
 * two tubes is rounded. The map is continuous, and smooth but for the plane y = 0 and the wall's
 * inner surface.
 */
class BifurcationShape
{
public:
  struct Tube
  {
    double direction; ///< of the axis away from the centre, from x towards y [rad]
    double inner_radius, wall_thickness; ///< [m]
  };

  /// `centre` [m] is where the axes meet; `tubes` in counter-clockwise order, each less than half a
  /// turn from the next.
  BifurcationShape(const dealii::Point<3> &centre, const std::array<Tube, 3> &tubes);

  /// The distance along the axis from which on a tube is straight and round [m].
  double reach(unsigned int tube) const { return branches[tube].reach; }
  /// Where the place is in space [m].
  dealii::Point<3> point(unsigned int tube, const dealii::Point<3> &place) const;
  /// The derivative of `point` with respect to the place; on y = 0 and on the wall's inner surface
  /// that of one side.
  dealii::Tensor<2, 3> derivative(unsigned int tube, const dealii::Point<3> &place) const;
  /// The place of a point that lies in the tube. Throws std::runtime_error if none is found.
  dealii::Point<3> place(unsigned int tube, const dealii::Point<3> &point) const;
  /// The least determinant of `derivative` over the lengths of its columns, over all the shape as
  /// points of a lattice see it: 1 where all is at right angles, not positive where the shape is
  /// folded.
  double least_scaled_determinant() const;

private:
  /// The half of a tube that ends in one half-surface, as seen in a mirror that puts it on y > 0.
  struct Half
  {
    double sign;         ///< of y
    double cosine, sine; ///< of the angle between the axis and the half-surface
    /// The semi-axis of the ellipse in the plane: of the wall's inner surface, and by how much that
    /// of the outer one is longer [m].
    double length, growth;
    /// The direction in which the axis arrives at the centre: along the half-surface's normal out
    /// of this tube, and along the half-surface away from the centre.
    double normal_part, tangent_part;
  };
  /// A known point, from which the inverse starts.
  struct Sample
  {
    dealii::Tensor<1, 3> point; ///< in the frame of axis, normal and z direction
    unsigned int half;
    double t, y, z;
  };
  struct Branch
  {
    dealii::Tensor<1, 3> axis, normal;
    double inner_radius, wall_thickness;
    double reach;
    std::array<Half, 2> halves;
    std::vector<Sample> samples;
  };
  /// A point in the frame of axis, normal and z direction, and its derivatives.
  struct LocalPoint
  {
    dealii::Tensor<1, 3> value;
    std::array<dealii::Tensor<1, 3>, 3> derivatives; ///< by t, y, z
  };

  /// Between the circle (t = 0) and the half-surface (t = 1); `in_wall`: by the law of the wall,
  /// wherever the place is.
  LocalPoint local_point(
      const Branch &branch, const Half &half, double t, double y, double z, bool in_wall) const;
  void set_half_surface(unsigned int left, unsigned int right);
  /// Newton's iteration for `target`, in the tube's frame, from a sample; whether it ended.
  bool find_place(const Branch &branch, const dealii::Tensor<1, 3> &target, Sample &sample) const;

  const dealii::Point<3> centre;
  std::array<Branch, 3> branches;
  /// The semi-axis of all ellipses along z, see Half::length [m].
  double height, height_growth;
};
} // namespace Continua

#endif
