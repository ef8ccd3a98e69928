#include <continua/mesh/bifurcation_manifold.h>
#include <continua/mesh/tube_cross_section.h>

#include "../unit_test.h"
#include "bifurcation_shapes.h"

#include <algorithm>
#include <vector>

namespace test_of_bifurcation_manifold
{
using namespace Continua;
using dealii::Point;
using Part = BifurcationManifold::Part;

namespace
{
const auto shape = std::make_shared<BifurcationShape>(
    bifurcation_shapes::make({25., 0.73, 0.16}, {30., 0.56, 0.12}));

/// Largest distance of a point of the chart that went into space and back; around, a whole turn is
/// none.
double round_trip(const BifurcationManifold &manifold, const std::vector<Point<3>> &points)
{
  double error = 0.;
  for (const Point<3> &point : points)
  {
    const Point<3> back = manifold.pull_back(manifold.push_forward(point));
    error = std::max(error, point.distance(back));
  }
  return error;
}

Point<3> middle(const dealii::Manifold<3> &manifold, const std::vector<Point<3>> &points)
{
  return manifold.get_new_point(
      dealii::make_array_view(points),
      dealii::make_array_view(std::vector<double>(points.size(), 1. / points.size())));
}

/// How far apart the two tubes of a half-surface put the middle of points on it, which are told by
/// the scaled coordinates.
double disagreement(const unsigned int tube, const std::vector<Point<2>> &scaled, const Part part)
{
  const unsigned int left = (tube + 1) % 3;
  std::vector<Point<3>> points;
  for (const Point<2> &place : scaled)
    points.push_back(shape->point(tube, {0., place[0], place[1]}));
  return middle(BifurcationManifold(shape, tube, part), points)
      .distance(middle(BifurcationManifold(shape, left, part), points));
}
} // namespace

UNIT_TEST(bifurcation_manifold)
{
  std::vector<Point<3>> in_core, in_rings;
  for (unsigned int i = 0; i < 3; ++i)
    for (const double a : {0., 0.1, 0.9, 1.7, 2.9, 4.})
    {
      for (const double y : {-0.4, -0.1, 0., 0.2, 0.42})
        for (const double z : {-0.3, 0., 0.4})
          in_core.emplace_back(a, y, z);
      for (const double rho : {0.05, 0.6, 1., 1.3, 2.})
        for (const double u : {0., 0.7, 1.9, 2.6, 4., 5.1, 6.3, 7.8})
          in_rings.emplace_back(a, rho, u);
    }
  for (unsigned int tube = 0; tube < 3; ++tube)
  {
    check::absolute("core: there and back",
                    round_trip(BifurcationManifold(shape, tube, Part::core), in_core), 0., 1e-12);
    check::absolute("rings: there and back",
                    round_trip(BifurcationManifold(shape, tube, Part::rings), in_rings), 0., 1e-10);
    check::absolute("core: neighbours agree",
                    disagreement(tube, {{0., 0.1}, {0.3, 0.1}, {0., 0.4}, {0.3, 0.4}}, Part::core),
                    0., 1e-14);
    const auto place = [](const double rho, const double u)
    { return TubeCrossSection::point(rho, u); };
    check::absolute("rings: neighbours agree",
                    disagreement(tube,
                                 {place(0.5, 0.), place(1., 0.), place(0.5, 0.5), place(1., 0.5)},
                                 Part::rings),
                    0., 1e-13);
    check::absolute("wall: neighbours agree",
                    disagreement(tube, {place(1., 7.), place(2., 7.), place(1., 8.), place(2., 8.)},
                                 Part::rings),
                    0., 1e-13);
    // A line on the surface between core and rings, from the axis' end to where the tube is round.
    const std::vector<Point<3>> line = {
        shape->point(tube, {0., 0.424264068711928, 0.1}),
        shape->point(tube, {shape->reach(tube), 0.42426406871192851, 0.1})};
    check::absolute("core and rings agree",
                    middle(BifurcationManifold(shape, tube, Part::core), line)
                        .distance(middle(BifurcationManifold(shape, tube, Part::rings), line)),
                    0., 1e-13);
  }
  // Half-way around the parent's outer surface between y and z at x = 2: z is 1.2 sin(45 degrees).
  const BifurcationManifold rings(shape, 0, Part::rings);
  const double q = 1.2 * std::sqrt(0.5);
  check::absolute("round",
                  middle(*rings.clone(), {{2., -1.2, 0.}, {2., 0., 1.2}}).distance({2., -q, q}), 0.,
                  1e-14);
  // Across u = 0, which is u = 8.
  const double c = 1.2 * std::cos(dealii::numbers::PI / 8.);
  const double s = 1.2 * std::sin(dealii::numbers::PI / 8.);
  check::absolute("across the end of a turn",
                  middle(rings, {{2., -c, -s}, {2., -c, s}}).distance({2., -1.2, 0.}), 0., 1e-14);
}
} // namespace test_of_bifurcation_manifold
