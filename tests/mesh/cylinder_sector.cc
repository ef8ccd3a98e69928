#include <continua/mesh/cylinder_sector.h>

#include "../unit_test.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace test_of_cylinder_sector
{
using namespace Continua;
using dealii::Point;
using dealii::numbers::PI;

namespace
{
/// The largest error of place(point(s, v)), a little beyond the sector, too.
double error_of_places(const CylinderSector &sector)
{
  double error = 0.;
  for (double s = 0.; s < 1.25; s += 0.05)
    for (double v = -0.25; v < 1.26; v += 1. / 64.)
      error = std::max(error, (sector.place(sector.point(s, v)) - Point<2>(s, v)).norm());
  return error;
}
} // namespace

UNIT_TEST(cylinder_sector)
{
  CylinderSector sector;
  sector.centre = Point<2>(3., 5.);
  sector.radius = 1.;
  sector.half_side = 2.;
  sector.angles = {{-0.25 * PI, 0.25 * PI}};
  sector.sides = {{-2., 2.}};
  const double diagonal = std::sqrt(0.5);
  // The middle of the side, and its corner, counter-clockwise from it: by hand.
  const Point<2> middles[] = {{5., 5.}, {3., 7.}, {1., 5.}, {3., 3.}};
  const Point<2> corners[] = {{5., 7.}, {1., 7.}, {1., 3.}, {5., 3.}};
  for (unsigned int quarter = 0; quarter < 4; ++quarter)
  {
    const std::string name = "quarter " + std::string(1, static_cast<char>('a' + quarter));
    sector.quarter = quarter;
    check::absolute(name + ": middle", (sector.point(1., 0.5) - middles[quarter]).norm(), 0.,
                    1e-15);
    check::absolute(name + ": corner", (sector.point(1., 1.) - corners[quarter]).norm(), 0., 1e-15);
    check::absolute(name + ": arc",
                    (sector.point(0., 1.) -
                     (sector.centre + 0.5 * diagonal * (corners[quarter] - sector.centre)))
                        .norm(),
                    0., 1e-15);
    check::absolute(name + ": places", error_of_places(sector), 0., 1e-13);
  }

  // Halfway along the line that ends at a quarter of the side and of the arc.
  sector.quarter = 0;
  check::absolute("inside",
                  (sector.point(0.5, 0.75) - Point<2>(3. + 0.5 * (std::cos(PI / 8.) + 2.),
                                                      5. + 0.5 * (std::sin(PI / 8.) + 1.)))
                      .norm(),
                  0., 1e-15);

  CylinderSector beside = sector;
  beside.angles = {{std::asin(0.6), 0.25 * PI}};
  beside.sides = {{0.6, 2.}};
  check::absolute("beside a thick beam: places", error_of_places(beside), 0., 1e-13);
  // Along the beam the sector begins with a line across which it does not jump.
  check::absolute("beside a thick beam: along it", beside.point(0.5, 0.)[1], 5.6, 1e-15);

  CylinderSector beam = sector;
  beam.is_beam = true;
  beam.sides = {{-0.6, 0.6}};
  check::absolute("beam: root", (beam.point(0., 1.) - Point<2>(3.8, 5.6)).norm(), 0., 1e-15);
  check::absolute("beam: halfway", (beam.point(0.5, 1.) - Point<2>(4.4, 5.6)).norm(), 0., 1e-15);
  check::absolute("beam: fibre", beam.point(0.3, 0.75)[1], 5.3, 1e-15);
  check::absolute("beam: places", error_of_places(beam), 0., 1e-13);

  // A narrow gap: the square nearly touches the circle.
  sector.half_side = 1.025;
  sector.sides = {{-1.025, 1.025}};
  check::absolute("narrow gap: places", error_of_places(sector), 0., 1e-12);
}
} // namespace test_of_cylinder_sector
