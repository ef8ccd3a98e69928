#include <continua/mesh/tube_cross_section.h>

#include "../unit_test.h"

#include <cmath>

namespace test_of_tube_cross_section
{
using namespace Continua;
using dealii::Point;

namespace
{
double
area(const TubeCrossSection &section, const unsigned int first_ring, const unsigned int end_ring)
{
  double sum = 0.;
  for (const auto &cell : section.cells())
    if (!cell.is_core && cell.ring >= first_ring && cell.ring < end_ring)
    {
      const auto a = section.vertices()[cell.vertices[3]] - section.vertices()[cell.vertices[0]];
      const auto b = section.vertices()[cell.vertices[2]] - section.vertices()[cell.vertices[1]];
      sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
  return sum;
}

double smallest_cell(const TubeCrossSection &section)
{
  double smallest = 1.;
  for (const auto &cell : section.cells())
  {
    std::array<Point<2>, 4> p;
    for (unsigned int v = 0; v < 4; ++v)
      p[v] = section.vertices()[cell.vertices[v]];
    // Twice the triangle at each corner.
    for (const auto &[o, a, b] :
         {std::array<unsigned int, 3>{{0, 1, 2}}, std::array<unsigned int, 3>{{1, 3, 0}},
          std::array<unsigned int, 3>{{2, 0, 3}}, std::array<unsigned int, 3>{{3, 2, 1}}})
      smallest = std::min(smallest, (p[a] - p[o])[0] * (p[b] - p[o])[1] -
                                        (p[a] - p[o])[1] * (p[b] - p[o])[0]);
  }
  return smallest;
}
} // namespace

UNIT_TEST(tube_cross_section)
{
  // The polygon between the circle of 2 n chords a quarter and the core, of which 2 (0.6^2 / 2) is
  // a quarter of the corners' square.
  const TubeCrossSection quarter({0., 0.4, 1., 1.5, 2.}, 4, TubeCrossSection::Sector::quarter);
  const double chords = 0.5 * 8. * std::sin(M_PI / 16.);
  check::relative("fluid's rings", area(quarter, 0, 2), chords - 0.18, 1e-13);
  check::relative("wall", area(quarter, 2, 4), 3. * chords, 1e-13);
  check::is_true("cells of a quarter", quarter.cells().size() == 16 + 4 * 8);
  // 5 x 5 in the core and 9 on each of 4 rings.
  check::is_true("vertices of a quarter", quarter.vertices().size() == 25 + 36);
  check::is_true("positive cells", smallest_cell(quarter) > 0.);

  const TubeCrossSection half({0., 0.4, 1., 1.5, 2.}, 4, TubeCrossSection::Sector::half);
  check::relative("half: wall", area(half, 2, 4), 6. * chords, 1e-13);
  check::is_true("half: vertices", half.vertices().size() == 45 + 4 * 17);
  check::is_true("half: above the plane",
                 std::all_of(half.vertices().begin(), half.vertices().end(),
                             [](const Point<2> &vertex) { return vertex[1] >= 0.; }));

  const TubeCrossSection full({0., 0.4, 1., 1.5, 2.}, 4, TubeCrossSection::Sector::full);
  check::relative("full: fluid's rings", area(full, 0, 2), 4. * (chords - 0.18), 1e-13);
  check::is_true("full: cells", full.cells().size() == 4 * quarter.cells().size());
  check::is_true("full: vertices", full.vertices().size() == 81 + 4 * 32);
  check::is_true("full: positive cells", smallest_cell(full) > 0.);

  double error = 0.;
  for (const double rho : {0., 0.3, 0.99, 1., 1.2, 2.})
    for (const double u : {0., 0.1, 0.5, 0.99, 1., 1.3, 2., 3.7, 4., 5.5, 6., 7., 7.9})
    {
      const Point<2> place = TubeCrossSection::place(TubeCrossSection::point(rho, u));
      error = std::max({error, std::abs(place[0] - rho), std::abs(place[1] - u)});
    }
  check::absolute("place of a point", error, 0., 1e-13);
  check::absolute(
      "on the circle",
      (TubeCrossSection::point(1., 0.5) - Point<2>(std::cos(M_PI / 8.), std::sin(M_PI / 8.)))
          .norm(),
      0., 1e-15);
  check::absolute(
      "on the core",
      (TubeCrossSection::point(0., 0.5) - 0.3 * std::sqrt(2.) * Point<2>(1., 0.5)).norm(), 0.,
      1e-15);
  check::absolute("outside", TubeCrossSection::point(2., 3.3).norm(), 2., 1e-15);
  check::is_true("planes", TubeCrossSection::point(0.3, 2.)[0] == 0. &&
                               TubeCrossSection::point(0.3, 4.)[1] == 0. &&
                               TubeCrossSection::point(1.7, 6.)[0] == 0. &&
                               TubeCrossSection::place({0., -0.9})[1] == 6.);
  check::absolute("turned back",
                  (TubeCrossSection::point(0.7, -0.4) - TubeCrossSection::point(0.7, 7.6)).norm(),
                  0., 1e-15);
}
} // namespace test_of_tube_cross_section
