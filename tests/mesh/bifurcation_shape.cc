#include "../unit_test.h"
#include "bifurcation_shapes.h"

#include <algorithm>
#include <vector>

namespace test_of_bifurcation_shape
{
using namespace Continua;
using bifurcation_shapes::Daughter;
using bifurcation_shapes::make;
using dealii::Point;
using dealii::Tensor;
using dealii::numbers::PI;

namespace
{
/// Places all over a tube and beyond its reach, and on its planes and surfaces.
std::vector<Point<3>> places(const BifurcationShape &shape, const unsigned int tube)
{
  std::vector<Point<3>> result;
  for (const double a : {0., 0.03, 0.31, 0.66, 0.97, 1., 1.4})
    for (const double radius : {0., 0.2, 0.85, 1., 1.1, 2.})
      for (const double turn : {0., 0.4, 1.2, 2.1, 3.1, 4.2, 5.5})
        result.emplace_back(a * shape.reach(tube), radius * std::cos(turn),
                            radius * std::sin(turn));
  for (const double z : {-2., -0.5, 0., 1., 1.7})
  {
    result.emplace_back(0.4 * shape.reach(tube), 0., z);
    result.emplace_back(0., z, 0.);
    result.emplace_back(0., 0., z);
  }
  return result;
}

/// Largest distance of a place that went to its point and back.
double round_trip(const BifurcationShape &shape)
{
  double error = 0.;
  for (unsigned int tube = 0; tube < 3; ++tube)
    for (const Point<3> &place : places(shape, tube))
      error = std::max(error, place.distance(shape.place(tube, shape.point(tube, place))));
  return error;
}

/// Largest difference of the derivative from a difference quotient, inside the smooth parts.
double error_of_derivative(const BifurcationShape &shape)
{
  constexpr double step = 1e-5;
  double error = 0.;
  for (unsigned int tube = 0; tube < 3; ++tube)
    for (const double a : {0.1, 0.5, 0.9, 1.2})
      for (const double radius : {0.3, 0.8, 1.4})
        for (const double turn : {0.3, 1.2, 2.5, 4., 6.})
        {
          const Point<3> place(a * shape.reach(tube), radius * std::cos(turn),
                               radius * std::sin(turn));
          const Tensor<2, 3> derivative = shape.derivative(tube, place);
          for (unsigned int d = 0; d < 3; ++d)
          {
            Point<3> after = place, before = place;
            after[d] += step;
            before[d] -= step;
            const Tensor<1, 3> quotient =
                (shape.point(tube, after) - shape.point(tube, before)) / (2. * step);
            for (unsigned int k = 0; k < 3; ++k)
              error = std::max(error, std::abs(derivative[k][d] - quotient[k]));
          }
        }
  return error;
}

/// The normal of the surface of that scaled radius.
Tensor<1, 3> normal(const BifurcationShape &shape,
                    const unsigned int tube,
                    const double a,
                    const double radius,
                    const double turn)
{
  const Point<3> place(a, radius * std::cos(turn), radius * std::sin(turn));
  const Tensor<2, 3> derivative = shape.derivative(tube, place);
  const Tensor<1, 3> along = derivative * Tensor<1, 3>(Point<3>(1., 0., 0.));
  const Tensor<1, 3> around =
      derivative * Tensor<1, 3>(Point<3>(0., -std::sin(turn), std::cos(turn)));
  const Tensor<1, 3> result = dealii::cross_product_3d(around, along);
  return result / result.norm();
}

/// How far the surfaces of neighbours are apart where they meet, and by how much their normals
/// differ there.
std::pair<double, double> gap_and_bend(const BifurcationShape &shape)
{
  double gap = 0., bend = 0.;
  for (unsigned int tube = 0; tube < 3; ++tube)
    for (const double radius : {0.5, 1., 2.})
      for (const double turn : {-1.5, -0.7, 0., 0.2, 1., 1.5})
      {
        const unsigned int left = (tube + 1) % 3;
        const double y = radius * std::cos(turn), z = radius * std::sin(turn);
        gap = std::max(gap, shape.point(tube, {0., y, z}).distance(shape.point(left, {0., -y, z})));
        if (radius >= 1.)
          bend = std::max(bend, (normal(shape, tube, 0., radius, turn) -
                                 normal(shape, left, 0., radius, PI - turn))
                                    .norm());
      }
  return {gap, bend};
}

/// The same where a tube begins to be round.
std::pair<double, double> gap_and_bend_at_reach(const BifurcationShape &shape)
{
  double gap = 0., bend = 0.;
  for (unsigned int tube = 0; tube < 3; ++tube)
    for (const double radius : {0.5, 1., 2.})
      for (const double turn : {0.2, 1., 2., 3.5, 5.})
      {
        const double y = radius * std::cos(turn), z = radius * std::sin(turn);
        const double before = shape.reach(tube) * (1. - 1e-14);
        gap = std::max(gap, shape.point(tube, {before, y, z})
                                .distance(shape.point(tube, {shape.reach(tube), y, z})));
        bend = std::max(bend, (normal(shape, tube, before, radius, turn) -
                               normal(shape, tube, shape.reach(tube), radius, turn))
                                  .norm());
      }
  return {gap, bend};
}

/// The least scaled determinant over angles of 15 to 80 degrees and ratios of radii of 0.5 to 1.
double least_of_range()
{
  double least = 1.;
  for (const double first : {15., 30., 50., 80.})
    for (const double second : {15., 25., 80.})
      for (const double first_radius : {0.5, 0.7, 1.})
        for (const double second_radius : {0.5, 1.})
          least = std::min(least, make({first, first_radius, 0.1}, {second, second_radius, 0.15})
                                      .least_scaled_determinant());
  return least;
}
} // namespace

UNIT_TEST(bifurcation_shape)
{
  const BifurcationShape carotid = make({25., 0.73, 0.16}, {30., 0.56, 0.12});
  const BifurcationShape wide = make({80., 0.5, 0.02}, {15., 1., 0.4});
  check::absolute("there and back", round_trip(carotid), 0., 1e-12);
  check::absolute("wide: there and back", round_trip(wide), 0., 1e-12);
  check::absolute("derivative", error_of_derivative(carotid), 0., 1e-8);
  check::absolute("wide: derivative", error_of_derivative(wide), 0., 1e-8);
  for (const BifurcationShape &shape : {carotid, wide})
  {
    const auto [gap, bend] = gap_and_bend(shape);
    check::absolute("neighbours meet", gap, 0., 1e-14);
    check::absolute("neighbours are smooth", bend, 0., 1e-12);
    const auto [gap_at_reach, bend_at_reach] = gap_and_bend_at_reach(shape);
    check::absolute("tubes meet", gap_at_reach, 0., 1e-12);
    check::absolute("tubes are smooth", bend_at_reach, 0., 1e-11);
  }

  // The parent's inner surface at x = 1, and the second daughter's outer one.
  check::absolute("parent", carotid.point(0, {4., 0.6, 0.8}).distance({1., -0.6, 0.8}), 0., 1e-15);
  const double c = std::cos(PI / 6.), s = 0.5;
  check::absolute(
      "daughter",
      carotid.point(1, {4., 2., 0.}).distance(Point<3>(5. + 4. * c + 0.68 * s, 0.68 * c - 2., 0.)),
      0., 1e-14);
  check::absolute("back", carotid.place(1, {5. + 4. * c, -2., 0.62}).distance({4., 0., 1.5}), 0.,
                  1e-14);
  check::is_true("symmetry is exact",
                 carotid.point(2, {0.7, -0.8, 0.})[2] == 0. &&
                     carotid.place(2, carotid.point(2, {0.7, -0.8, 0.}))[2] == 0.);

  // Equal daughters: the axis of the crotch is x, its tip a point of both tubes.
  const BifurcationShape fork = make({40., 0.8, 0.2}, {40., 0.8, 0.2});
  const Point<3> tip = fork.point(1, {0., 1., 0.});
  check::absolute("tip", tip[1], 0., 1e-15);
  // An arc of the radius R tan(40 degrees) + h about the point where lines R + h + R tan(40
  // degrees) beside the axes meet.
  const double tangent = std::tan(40. * PI / 180.), arc = 0.8 * tangent + 0.2;
  check::relative("round tip", tip[0] - 5., (0.8 + arc) / std::sin(40. * PI / 180.) - arc, 1e-13);
  double error = 0.;
  for (const Point<3> &place : places(fork, 1))
  {
    const Point<3> point = fork.point(1, place);
    const Point<3> mirrored = fork.point(2, {place[0], -place[1], place[2]});
    error = std::max(error, point.distance({mirrored[0], -mirrored[1], mirrored[2]}));
  }
  check::absolute("mirrored daughters", error, 0., 1e-14);

  check::is_true("no cell is folded", least_of_range() > 0.1);
  check::is_true("folded", make({2., 1., 0.2}, {2., 1., 0.2}).least_scaled_determinant() < 0.01);
  check::throws<std::runtime_error>(
      "point elsewhere",
      [&] {
        carotid.place(1, {0., 0., 0.});
      },
      "not in its branch");
}
} // namespace test_of_bifurcation_shape
