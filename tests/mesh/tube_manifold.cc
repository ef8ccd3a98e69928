#include <continua/mesh/tube_manifold.h>

#include "../unit_test.h"

namespace test_of_tube_manifold
{
using namespace Continua;
using dealii::Point;

namespace
{
const TubeLaw law = TubeLaw::taper(2., 2., 1., 0.1, 0.3);

/// Largest distance of a point that went to the chart and back.
template <int dim>
double round_trip(const TubeManifold<dim> &manifold, const std::vector<Point<dim>> &points)
{
  double error = 0.;
  for (const Point<dim> &point : points)
    error = std::max(error, point.distance(manifold.push_forward(manifold.pull_back(point))));
  return error;
}

template <int dim>
Point<dim> middle(const dealii::Manifold<dim> &manifold, const Point<dim> &a, const Point<dim> &b)
{
  return manifold.get_intermediate_point(a, b, 0.5);
}
} // namespace

UNIT_TEST(tube_manifold)
{
  // At x = 1 the inner radius is 0.75 and the wall 0.2 thick.
  check::relative("radius in the fluid", TubeManifold<2>::radius(law, 1., 0.4), 0.3, 1e-14);
  check::relative("radius in the wall", TubeManifold<2>::radius(law, 1., 1.25), 0.8, 1e-14);

  const TubeManifold<2> section(law, TubeManifold<2>::Part::rings);
  check::absolute("section: there and back",
                  round_trip<2>(section, {{0., 0.}, {0.3, 0.5}, {1., 0.75}, {1.2, 0.8}, {2., 0.8}}),
                  0., 1e-15);
  // A rigid tube: points of the rim may lie outside by round-off.
  TubeLaw rigid = law;
  rigid.set_layers({}, {});
  const double beyond = 1. + 4e-16;
  check::absolute("rigid section: there and back",
                  round_trip<2>(TubeManifold<2>(rigid, TubeManifold<2>::Part::rings),
                                {{0., 0.}, {0., beyond}, {1., 0.75 * beyond}, {2., 0.5 * beyond}}),
                  0., 1e-15);
  for (const auto part : {TubeManifold<3>::Part::rings, TubeManifold<3>::Part::core})
    check::absolute("rigid: there and back",
                    round_trip<3>(TubeManifold<3>(rigid, part), {{0., beyond, 0.},
                                                                 {1., 0., 0.75 * beyond},
                                                                 {1., 0.45 * beyond, 0.6 * beyond},
                                                                 {2., -0.3, 0.4 * beyond}}),
                    0., 1e-14);

  // From the inner surface at x = 0 to the outer one at x = 2: half-way up the wall at x = 1.
  check::absolute("section: in the wall",
                  middle<2>(*section.clone(), {0., 1.}, {2., 0.8}).distance({1., 0.85}), 0., 1e-14);

  const TubeManifold<3> rings(law, TubeManifold<3>::Part::rings);
  const TubeManifold<3> core(law, TubeManifold<3>::Part::core);
  check::absolute(
      "rings: there and back",
      round_trip<3>(
          rings,
          {{0., 0.7, 0.}, {0.3, 0.5, -0.5}, {1., -0.45, 0.6}, {1.2, 0., -0.8}, {2., -0.6, -0.4}}),
      0., 1e-14);
  check::absolute("core: there and back",
                  round_trip<3>(core, {{0., 0., 0.}, {0.3, 0.2, -0.2}, {1., -0.3, 0.}}), 0., 1e-15);
  const double q = std::sqrt(0.5);
  check::absolute(
      "round", middle<3>(rings, {1., 0.75, 0.}, {1., 0., 0.75}).distance({1., 0.75 * q, 0.75 * q}),
      0., 1e-14);
  // The y axis is at once u = 0 and u = 8.
  const double c = std::cos(dealii::numbers::PI / 8.);
  const double s = std::sin(dealii::numbers::PI / 8.);
  check::absolute("across the y axis",
                  middle<3>(rings, {1., 0.75 * c, -0.75 * s}, {1., 0.75 * c, 0.75 * s})
                      .distance({1., 0.75, 0.}),
                  0., 1e-14);
  // On the core's side both charts are straight in the scaled section.
  const double side = 0.6 * q;
  const Point<3> a(0., side, 0.);
  const Point<3> b(2., 0.5 * side, 0.5 * side);
  check::absolute("charts agree between core and rings",
                  middle<3>(rings, a, b).distance(middle<3>(core, a, b)), 0., 1e-14);
  check::absolute("the place there",
                  middle<3>(core, a, b).distance({1., 0.75 * side, 0.375 * side}), 0., 1e-14);
}
} // namespace test_of_tube_manifold
