#include <continua/mesh/grading.h>

#include "../unit_test.h"

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

  // Sizes 1, 3, 9, 3, 1 in 17: the ends have a ninth of the middle.
  const auto odd = symmetrically_graded_points(0., 17., 5, 1. / 9.);
  check::relative("odd: end", odd[1], 1., 1e-14);
  check::relative("odd: next", odd[2], 4., 1e-14);
  check::relative("odd: middle", odd[3], 13., 1e-14);
  check::relative("odd: last", odd[4], 16., 1e-14);

  // Sizes 1, 5, 5, 1 in 12.
  const auto even = symmetrically_graded_points(0., 12., 4, 0.2);
  check::relative("even: end", even[1], 1., 1e-14);
  check::relative("even: middle", even[2], 6., 1e-14);
  check::relative("even: last", even[3], 11., 1e-14);

  check::is_true("two cells are equal", symmetrically_graded_points(0., 2., 2, 0.1)[1] == 1.);
}
