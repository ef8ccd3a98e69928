// Where a function changes its sign, from points in any order.

#include "../unit_test.h"

#include <continua/signal/sign_change.h>

#include <cmath>

namespace test_of_sign_change
{
using namespace Continua;

UNIT_TEST(sign_change)
{
  // Positive to 2, negative to 5, positive again; with a value of 0 on the way.
  const std::vector<std::pair<double, double>> points = {{4., -2.}, {1., 3.}, {3., -3.},
                                                         {6., 1.},  {0., 1.}, {4.5, 0.}};
  check::relative("the first", find_sign_change(points, 0), 2., 1e-15);
  check::relative("the second, across a zero", find_sign_change(points, 1), 4. + 4. / 3., 1e-15);
  check::is_true("there is no third", std::isnan(find_sign_change(points, 2)));
  check::is_true("none of one point", std::isnan(find_sign_change({{1., 1.}}, 0)));
  check::is_true("none of zeros", std::isnan(find_sign_change({{0., 0.}, {1., 0.}}, 0)));
  check::relative("at a jump of the position's value", find_sign_change({{1., -1.}, {1., 1.}}, 0),
                  1., 1e-15);
}
} // namespace test_of_sign_change
