#include <continua/base/difference_formula.h>

#include "../unit_test.h"

#include <cmath>
#include <functional>
#include <stdexcept>

namespace test_of_difference_formula
{
using namespace Continua;

double derivative(const DifferenceFormula &formula,
                  const std::vector<double> &weights,
                  const std::function<double(double)> &function)
{
  double sum = 0.;
  for (std::size_t i = 0; i < formula.nodes.size(); ++i)
    sum += weights[i] * function(formula.nodes[i]);
  return sum;
}

UNIT_TEST(difference_formula)
{
  const auto quartic = [](const double x) { return x * x * x * x - 2. * x; };
  const DifferenceFormula inside = DifferenceFormula::at(3., [](double) { return true; });
  check::relative("quartic", derivative(inside, inside.weights, quartic), 106., 1e-10);
  const auto exact = [&inside](const std::vector<double> &weights)
  {
    return std::abs(derivative(inside, weights, [](const double x) { return std::exp(x); }) -
                    std::exp(3.));
  };
  check::is_true("coarser is more than the error",
                 exact(inside.coarser_weights) > 10. * exact(inside.weights));

  // Poisson's ratio of an incompressible solid, and a number that may only grow.
  const auto cubic = [](const double x) { return x * x * x; };
  const DifferenceFormula below =
      DifferenceFormula::at(0.5, [](const double x) { return x <= 0.5; });
  check::relative("at an upper bound", derivative(below, below.weights, cubic), 0.75, 1e-9);
  const DifferenceFormula above =
      DifferenceFormula::at(-2., [](const double x) { return x >= -2.; });
  check::relative("at a lower bound", derivative(above, above.weights, cubic), 12., 1e-9);
  bool is_refused = false;
  try
  {
    DifferenceFormula::at(1., [](const double x) { return x == 1.; });
  }
  catch (const std::invalid_argument &)
  {
    is_refused = true;
  }
  check::is_true("no value beside its own", is_refused);
}
} // namespace test_of_difference_formula
