// A random field of places has the size that it says, other values in other components, and no
// length below the shortest wave.

#include "../unit_test.h"

#include <continua/analysis/random_field.h>

#include <cmath>

namespace test_of_random_field
{
using namespace Continua;
using namespace dealii;

UNIT_TEST(random_field)
{
  std::mt19937_64 generator(1);
  const RandomField<2> first(generator, 3.), second(generator, 3.);
  double squares = 0., products = 0., of_components = 0., steps = 0.;
  constexpr unsigned int n = 200;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
    {
      const Point<2> place(3. * i / n, 3. * j / n);
      const double value = first.value(place, 0);
      squares += value * value / (n * n);
      products += value * second.value(place, 0) / (n * n);
      of_components += value * first.value(place, 1) / (n * n);
      const double beside = first.value(place + Point<2>(1e-6, 0.), 0);
      steps = std::max(steps, std::abs(beside - value));
    }
  // Half of the square of 24 cosines, each of which may be longer than the body.
  check::absolute("mean square", squares, 1., 0.5);
  check::absolute("another field", products, 0., 0.3);
  check::absolute("another component", of_components, 0., 0.3);
  // The shortest wave has the length 3 m/100; all 24 together have the size sqrt(2 24) at most.
  check::is_true("no shorter wave", steps < 1e-6 * 2. * M_PI / 0.03 * std::sqrt(48.));
  check::is_true("it varies", steps > 1e-6);
  std::mt19937_64 same(1);
  const RandomField<2> again(same, 3.);
  check::is_true("the same in each run", again.value({1., 2.}, 1) == first.value({1., 2.}, 1));
  // The sum of the 24 cosines, computed apart from this class with the numbers of the generator.
  check::absolute("the same with any library", again.value({1., 2.}, 1), 2.404113796764, 1e-9);
}
} // namespace test_of_random_field
