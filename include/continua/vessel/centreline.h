#ifndef continua_vessel_centreline_h
#define continua_vessel_centreline_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Continua
{
/**
 * The line in space along which a vessel lies, with a frame at each of its places. A place is told
 * by the length of the line from its beginning, the *position* [m]. Beyond its ends the line is
 * straight.
 *
 * A cubic spline goes through the given points; its tangent at either end is that of the cubic
 * through the four outermost points. The spline's parameter is the length of the line: exactly at
 * the given points; in between to fourth order of the angle by which the line turns from one point
 * to the next (within 7e-5 of the distance for 11 degrees).
 *
 * The frame does not twist: normal and binormal turn with the tangent, but not about it (double
 * reflection of Wang et al., ACM Trans. Graph. 27, 2008, doi 10.1145/1330511.1330513). Where the
 * points lie in a plane, the binormal is that plane's normal at every place.
 */
class Centreline
{
public:
  using Point = dealii::Point<3>;
  using Tensor = dealii::Tensor<1, 3>;
  struct Frame
  {
    Point point;                      ///< [m]
    Tensor tangent, normal, binormal; ///< right-handed, of length one
  };

  /// `points` [m] in their order, at least two, neighbours at different places.
  explicit Centreline(const std::vector<Point> &points);

  double length() const { return knots.back(); } ///< [m]
  /// The positions of the given points [m].
  const std::vector<double> &positions_of_points() const { return knots; }
  Point point(double position) const;      ///< [m]
  Tensor tangent(double position) const;   ///< of length one
  double curvature(double position) const; ///< [1/m]; zero beyond the ends
  Frame frame(double position) const;
  /// The position of the place that is nearest to a point [m].
  double nearest(const Point &point) const;
  /// Positions [m] from 0 to length(), `samples_per_interval` between two given points: close
  /// enough together to look for something along the line.
  const std::vector<double> &samples() const { return sample_positions; }

private:
  static constexpr unsigned int samples_per_interval = 8;

  /// The spline and its derivatives at a position between 0 and length().
  struct Derivatives
  {
    Point point;
    Tensor first, second;
  };
  Derivatives derivatives(double position) const;
  /// Of the interval of `values` (ascending) in which the position is.
  static std::size_t interval(const std::vector<double> &values, double position);
  /// Gives the knots their slopes: the spline is smooth up to its second derivative.
  void fit();
  /// The length of the present spline between the knots i and i + 1 [m].
  double length_of_interval(std::size_t i) const;
  void make_frames();

  std::vector<Point> points;
  std::vector<double> knots;            ///< positions of the points [m]
  std::vector<Tensor> slopes;           ///< of the spline at the knots
  std::vector<double> sample_positions; ///< [m]
  std::vector<Point> sample_points;
  std::vector<double> arc_lengths; ///< from the first one, along the polyline of all [m]
  std::vector<Tensor> sample_normals;
};
} // namespace Continua

#endif
