// Sums of coefficients times values: what occurs twice adds, numbers become vectors.

#include <continua/finite_volume/stencil.h>

#include <deal.II/base/tensor.h>

#include "../unit_test.h"

namespace test_of_stencil
{
using namespace Continua;

UNIT_TEST(stencil)
{
  Stencil<double> numbers(7, 2.);
  numbers.add(3, 5.);
  numbers.add(7, -0.5);
  check::is_true("two values", numbers.size() == 2);
  double sum = 0.;
  for (const auto &[index, coefficient] : numbers)
    sum += coefficient * index;
  check::absolute("sum", sum, 1.5 * 7. + 5. * 3., 0.);

  Stencil<dealii::Tensor<1, 2>> vectors;
  vectors.add(dealii::Tensor<1, 2>({1., -2.}), numbers);
  const Stencil<dealii::Tensor<1, 2>> copy(vectors);
  vectors.add(3., copy);
  check::is_true("two vectors", vectors.size() == 2);
  for (const auto &[index, coefficient] : vectors)
  {
    const double expected = 4. * (index == 7 ? 1.5 : 5.);
    check::absolute("factor times other", coefficient[0] - expected, 0., 0.);
    check::absolute("its second component", coefficient[1] + 2. * expected, 0., 0.);
  }
}
} // namespace test_of_stencil
