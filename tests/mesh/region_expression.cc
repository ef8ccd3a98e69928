#include <continua/mesh/region_expression.h>

#include "../unit_test.h"

#include <stdexcept>

namespace test_of_region_expression
{
using namespace Continua;

namespace
{
void refused(const std::string &text, const std::string &pattern)
{
  check::throws<std::invalid_argument>(
      "refused: " + text, [&text] { RegionExpression expression(text); }, pattern);
}
} // namespace

UNIT_TEST(region_expression)
{
  check::relative("place", RegionExpression("x + 10*y + 100*z").value(1., 2., 3.), 321., 1e-15);
  check::relative("constants", RegionExpression("pi - e").value(0., 0., 0.), 0.42331082513, 1e-10);
  check::relative("power", RegionExpression("pow(x, 2) + y^3").value(3., 2., 0.), 17., 1e-15);
  const RegionExpression either("if(x >= 1 && y != 2, 5, -5)");
  check::is_true("condition holds", either.value(1., 0., 0.) == 5.);
  check::is_true("condition fails", either.value(1., 2., 0.) == -5.);

  refused("", ".");
  refused("x +", ".");
  refused("t - 1", "t");
  refused("1,5", "commas");
  refused("x = 2", "==");
  refused("if x then 1", "CONDITION");
  check::throws<std::invalid_argument>(
      "nested too deep",
      [] { RegionExpression expression(std::string(9000, '(') + "x" + std::string(9000, ')')); },
      "more than 100 brackets");
}
} // namespace test_of_region_expression
