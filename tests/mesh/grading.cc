#include <continua/mesh/grading.h>

#include "../unit_test.h"

#include <limits>

namespace test_of_grading
{
using namespace Continua;

UNIT_TEST(grading)
{
  // Sizes 1, 2, 4 in 7.
  std::vector<double> points = {1.};
  append_graded_cells(points, 8., 3, 4.);
  check::absolute("number of points", points.size(), 4., 0.);
  check::relative("first", points[1], 2., 1e-14);
  check::relative("second", points[2], 4., 1e-14);
  check::is_true("end is exact", points[3] == 8.);

  append_graded_cells(points, 9., 1, 100.);
  check::is_true("one cell has no grading", points.size() == 5 && points[4] == 9.);

  const double none = std::numeric_limits<double>::infinity();
  // Sizes 1, 3, 9, 9, 9, 3, 1 in 35.
  const auto both = points_with_end_zones(0., 35., 7, {{1., 1.}}, 3.);
  const std::vector<double> expected = {0., 1., 4., 13., 22., 31., 34., 35.};
  for (unsigned int i = 0; i < expected.size(); ++i)
    check::absolute("both ends, point " + std::to_string(i), both[i], expected[i], 1e-12);
  check::is_true("the last point is exact", both.back() == 35.);

  // Sizes 2, 3, 3, 1.5 in 9.5 from 0.5.
  const auto differing = points_with_end_zones(0.5, 10., 4, {{2., 1.5}}, 2.);
  check::relative("differing: first", differing[1], 2.5, 1e-12);
  check::relative("differing: second", differing[2], 5.5, 1e-12);
  check::relative("differing: third", differing[3], 8.5, 1e-12);

  // Sizes 1, 2, 2.5, 2.5 in 8.
  const auto one = points_with_end_zones(0., 8., 4, {{1., none}}, 2.);
  check::relative("one end: first", one[1], 1., 1e-12);
  check::relative("one end: last", one[3], 5.5, 1e-12);

  const auto equal = points_with_end_zones(0., 4., 4, {{none, 1.5}}, 2.);
  for (unsigned int i = 1; i < 4; ++i)
    check::relative("equal cells, point " + std::to_string(i), equal[i], i, 1e-12);

  // Sizes 1, 2, 2, 1 are too short for 12.
  const auto few = points_with_end_zones(0., 12., 4, {{1., 1.}}, 2.);
  check::relative("few cells: first", few[1], 2., 1e-12);
  check::relative("few cells: middle", few[2], 6., 1e-12);
  check::is_true("one cell", points_with_end_zones(0., 2., 1, {{1e-3, none}}, 1.5).size() == 2);

  // Sizes 1, 2, 4 in 7.
  check::relative("last of three", ratio_for_last_cell(3, 4. / 7., 10.), 1., 1e-12);
  check::relative("graded three", ratio_for_last_cell(3, 1. / 7., 10.), 0.25, 1e-10);
  check::relative("growth", ratio_for_last_cell(3, 1e-3, 2.), 0.25, 1e-12);
  check::relative("fine enough", ratio_for_last_cell(200, 1. / 128., 2.), 1., 1e-12);
  check::relative("last of one", ratio_for_last_cell(1, 1. / 128., 2.), 1., 1e-12);
}
} // namespace test_of_grading
