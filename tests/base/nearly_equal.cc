#include <continua/base/nearly_equal.h>

#include <vector>

#include "../unit_test.h"

namespace test_of_nearly_equal
{
UNIT_TEST(nearly_equal)
{
  using Continua::nearly_equal;
  check::is_true("rounding", nearly_equal({1., -3e9}, {1. + 1e-13, -3e9 - 1e-4}));
  check::is_true("one entry differs", !nearly_equal({1., -3e9}, {1. + 1e-11, -3e9}));
  const std::vector<double> zero = {0.}, small = {1e-30}, one = {1.};
  check::is_true("zeros", nearly_equal(zero, zero) && !nearly_equal(zero, small));
  check::is_true("another size", !nearly_equal(one, {1., 0.}));
  check::is_true("numbers", nearly_equal(-3e9, -3e9 - 1e-4) && nearly_equal(0., 0.) &&
                                !nearly_equal(1., 1. + 1e-11) && !nearly_equal(0., 1e-30));
}
} // namespace test_of_nearly_equal
