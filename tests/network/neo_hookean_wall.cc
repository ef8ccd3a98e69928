// The closed form of a thick neo-Hookean tube against a quadrature over its wall, and its small
// strain against the speed of long waves.

#include <continua/network/neo_hookean_wall.h>
#include <continua/network/square_root_wall.h>
#include <continua/theory/korteweg.h>

#include <cmath>

#include "../unit_test.h"

namespace test_of_neo_hookean_wall
{
using namespace Continua;

namespace
{
constexpr double pi = 3.14159265358979323846;

/// The integral of mu (r^2/R^2 - R^2/r^2)/r over the present wall, with R^2 = r^2 - a^2 + A^2.
double pressure_by_quadrature(const double inner,
                              const double outer,
                              const double present,
                              const double shear_modulus)
{
  constexpr unsigned int n = 2000;
  const double difference = present * present - inner * inner,
               end = std::sqrt(outer * outer + difference), step = (end - present) / n;
  double sum = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double r = present + (i + 0.5) * step, ratio = r * r / (r * r - difference);
    sum += (ratio - 1. / ratio) / r;
  }
  return shear_modulus * sum * step;
}
} // namespace

UNIT_TEST(neo_hookean_wall)
{
  const double inner = 0.01, outer = 0.014, modulus = 1e5, area = pi * inner * inner,
               wall_area = pi * (outer * outer - inner * inner);
  const NeoHookeanWall wall(area, wall_area, 500., modulus);
  for (const double stretch : {0.8, 1.001, 1.3, 1.7})
  {
    const std::string name = "stretch " + std::to_string(stretch);
    const double present = pi * stretch * stretch * inner * inner, step = 1e-5 * present;
    check::relative(name + ": pressure", wall.pressure(present) - 500.,
                    pressure_by_quadrature(inner, outer, stretch * inner, modulus), 1e-6);
    check::relative(name + ": stiffness", wall.stiffness(present),
                    (wall.pressure(present + step) - wall.pressure(present - step)) / (2. * step),
                    1e-6);
    check::relative(name + ": area", wall.area(wall.pressure(present), area), present, 1e-12);
  }
  check::is_true(
      "above the largest pressure there is no area",
      std::isnan(wall.area(500. + 0.5 * modulus * std::log1p(wall_area / area) + 1., area)));

  const LongWaveTube tube{inner, outer - inner, 0.5, 1000., 0.};
  const double speed =
      korteweg_speed(tube, 3. * modulus, Anchoring::throughout, WallTheory::thick).real();
  check::relative("small strain: speed of Korteweg in a thick wall",
                  std::sqrt(area * wall.stiffness(area) / 1000.), speed, 1e-12);
  const SquareRootWall root(area, 500., 1000. * speed * speed);
  check::relative("square root: stiffness at A0", root.stiffness(area), wall.stiffness(area),
                  1e-12);
  check::relative("square root: area", root.area(root.pressure(1.2 * area), area), 1.2 * area,
                  1e-13);
  check::is_true("square root: a closed tube has no area", std::isnan(root.area(-1e6, area)));
}
} // namespace test_of_neo_hookean_wall
