#include <continua/vessel/centreline.h>

#include "../unit_test.h"

#include <cmath>
#include <functional>

namespace test_of_centreline
{
using namespace Continua;
using Point = dealii::Point<3>;

namespace
{
constexpr double pi = 3.14159265358979323846;

/// Points at `n` + 1 places of a line whose parameter runs from 0 to 1.
std::vector<Point> points_of(const std::function<Point(double)> &line, const unsigned int n)
{
  std::vector<Point> points;
  for (unsigned int i = 0; i <= n; ++i)
    points.push_back(line(static_cast<double>(i) / n));
  return points;
}

/// A half circle of radius 2 around (0, 2, 1), in the plane z = 1.
Point half_circle(const double t)
{
  return {2. * std::sin(pi * t), 2. - 2. * std::cos(pi * t), 1.};
}

/// Two turns around the z axis, of radius 1 and pitch pi.
Point helix(const double t)
{
  return {std::cos(4. * pi * t), std::sin(4. * pi * t), 2. * pi * t};
}

void test_straight()
{
  const Centreline line({Point(1., 0., 0.), Point(1., 3., 4.)});
  check::relative("straight: length", line.length(), 5., 1e-15);
  check::absolute("straight: point", line.point(2.).distance(Point(1., 1.2, 1.6)), 0., 1e-14);
  check::absolute("straight: before the begin", line.point(-1.).distance(Point(1., -0.6, -0.8)), 0.,
                  1e-14);
  check::absolute("straight: nearest", line.nearest(Point(4., 1.2 - 0.8, 1.6 + 0.6)), 2., 1e-13);
  check::absolute("straight: nearest before", line.nearest(Point(4., -0.6, -0.8)), -1., 1e-13);
  check::absolute("straight: nearest behind", line.nearest(Point(1., 6., 8.)), 10., 1e-13);
  check::absolute("straight: curvature", line.curvature(2.), 0., 1e-13);
  // Along x the frame is that of the axes, so that a table on the x axis makes the tube along x.
  const Centreline along_x({Point(0., 0., 0.), Point(1., 0., 0.), Point(3., 0., 0.)});
  const Centreline::Frame frame = along_x.frame(0.7);
  check::absolute("along x: normal", (frame.normal - Point::unit_vector(1)).norm(), 0., 1e-15);
  check::absolute("along x: binormal", (frame.binormal - Point::unit_vector(2)).norm(), 0., 1e-15);
}

double largest_distance(const Centreline &line)
{
  double error = 0.;
  for (unsigned int i = 0; i <= 100; ++i)
    error = std::max(
        error, std::abs((line.point(0.01 * i * line.length()) - Point(0., 2., 1.)).norm() - 2.));
  return error;
}

void test_circle()
{
  const Centreline coarse(points_of(half_circle, 8)), fine(points_of(half_circle, 16));
  check::relative("circle: length", fine.length(), 2. * pi, 2e-5);
  const double order =
      std::log2(std::abs(coarse.length() - 2. * pi) / std::abs(fine.length() - 2. * pi));
  check::is_true("circle: order of the length above 3", order > 3.);
  // The parameter is the length at the points, and nearly so between them.
  double between = 0.;
  for (unsigned int i = 0; i < 16; ++i)
  {
    double sum = 0.;
    const double begin = fine.positions_of_points()[i], end = fine.positions_of_points()[i + 1];
    for (unsigned int k = 0; k < 500; ++k)
      sum += fine.point(begin + 0.5 * (end - begin) * (k + 1) / 500.)
                 .distance(fine.point(begin + 0.5 * (end - begin) * k / 500.));
    between = std::max(between, std::abs(sum / (0.5 * (end - begin)) - 1.));
  }
  check::absolute("circle: length between the points", between, 0., 1e-4);
  check::is_true("circle: order of the distance above 3",
                 std::log2(largest_distance(coarse) / largest_distance(fine)) > 3.);
  // The position is the length, between the points as well.
  double error = 0., turn = 0., nearest = 0., curvature = 0.;
  for (unsigned int i = 0; i < 50; ++i)
  {
    const double position = (i + 0.5) / 50. * fine.length(), angle = position / 2.;
    error = std::max(error, fine.point(position).distance(half_circle(angle / pi)));
    const Centreline::Frame frame = fine.frame(position);
    turn = std::max({turn, (frame.binormal - Point::unit_vector(2)).norm(),
                     std::abs(frame.tangent * frame.normal), std::abs(frame.normal.norm() - 1.)});
    const Point beside = frame.point + 0.9 * frame.normal - 0.7 * frame.binormal;
    nearest = std::max(nearest, std::abs(fine.nearest(beside) - position));
    // The error of the slope at an end, ten times as large here, falls by 0.27 from point to point.
    if (i > 12 && i < 37)
      curvature = std::max(curvature, std::abs(2. * fine.curvature(position) - 1.));
  }
  // The slope at an end, of a cubic through points h apart, is wrong by h^3 f''''/4, which the
  // spline has as h^4 f''''/27; elsewhere its error is 5 h^4 f''''/384. Here h = pi/8 and f'''' =
  // 1/8.
  check::absolute("circle: points", error, 0., std::pow(pi / 8., 4) / 8. * (1. / 27. + 5. / 384.));
  check::absolute("circle: frame without twist", turn, 0., 1e-13);
  check::absolute("circle: nearest", nearest, 0., 1e-12);
  // The second derivative of a spline is wrong by h^2 f''''/12 at its points.
  check::absolute("circle: curvature", curvature, 0., 1.05 * std::pow(pi / 16., 2) / 12.);
}

void test_helix()
{
  const Centreline line(points_of(helix, 64));
  const double radius = 1., rise = 0.5; // for each radian
  const double length = 4. * pi * std::hypot(radius, rise);
  check::relative("helix: length", line.length(), length, 2e-6);
  check::relative("helix: curvature", line.curvature(0.5 * length),
                  radius / (radius * radius + rise * rise), 1.05 * std::pow(pi / 16., 2) / 12.);
  // A frame without twist turns against that of Frenet by the integral of the torsion.
  const double torsion = rise / (radius * radius + rise * rise);
  const auto angle_to_frenet = [&](const double position)
  {
    const Centreline::Frame frame = line.frame(position);
    const Point to_axis = Point(-frame.point[0], -frame.point[1], 0.);
    return std::atan2(to_axis * frame.binormal, to_axis * frame.normal);
  };
  double turned = angle_to_frenet(0.75 * line.length()) - angle_to_frenet(0.25 * line.length());
  turned -= torsion * 0.5 * length;
  check::absolute("helix: turn against Frenet's frame", std::remainder(turned, 2. * pi), 0., 1e-3);
  // The nearest place is on the same turn, not on the one above.
  double error = 0.;
  for (unsigned int i = 0; i < 40; ++i)
  {
    const double position = (i + 0.5) / 40. * line.length();
    const Centreline::Frame frame = line.frame(position);
    error = std::max(error, std::abs(line.nearest(frame.point + 0.6 * frame.normal) - position));
    error = std::max(error, std::abs(line.nearest(frame.point - 0.6 * frame.binormal) - position));
  }
  check::absolute("helix: nearest", error, 0., 1e-12);

  // Wherever a place is: near the axis, between turns and far away, no sample is nearer, and far
  // away from the origin, too.
  bool is_nearest = true;
  for (const double shift : {0., 1e3})
  {
    std::vector<Point> points = points_of(helix, 64);
    for (Point &point : points)
      point[0] += shift;
    const Centreline moved(points);
    for (unsigned int i = 0; i < 300; ++i)
    {
      const double size = i % 3 == 0 ? 0.1 : i % 3 == 1 ? 2. : 30.;
      const Point place(shift + size * std::sin(1. * i * i), size * std::sin(2. * i * i),
                        3. + size * std::sin(3. * i * i));
      const double position = moved.nearest(place);
      const double distance = place.distance(moved.point(position));
      for (const double sample : moved.samples())
        is_nearest &= distance <= place.distance(moved.point(sample)) + 1e-9;
    }
  }
  check::is_true("helix: no sample is nearer", is_nearest);
}
} // namespace

UNIT_TEST(centreline)
{
  test_straight();
  test_circle();
  test_helix();
}
} // namespace test_of_centreline
