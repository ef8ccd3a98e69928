// The viscosity over the rate of shear: its limits, values of blood by hand, and its slope against
// differences.

#include <continua/materials/flow_curve.h>

#include <cmath>

#include "../unit_test.h"

namespace test_of_flow_curve
{
using namespace Continua;

UNIT_TEST(flow_curve)
{
  const FlowCurve blood{0.056, 0.00345, 3.313, 0.3568, 2.};
  check::relative("at rest", blood.viscosity(0.), 0.056, 1e-15);
  check::relative("at a very high rate", blood.viscosity(1e12), 0.00345, 1e-5);
  // (1 + 3.313^2)^(-0.3216) = 0.449713...: by a calculator.
  check::relative("at 1/s", blood.viscosity(1.),
                  0.00345 + 0.05255 * std::exp(-0.3216 * std::log(11.975969)), 1e-12);
  check::absolute("a Newtonian index", FlowCurve{0.01, 0.002, 5., 1., 2.}.viscosity(7.), 0.01,
                  1e-17);
  for (const double exponent : {0.7, 2.})
  {
    const FlowCurve curve{0.056, 0.00345, 3.313, 0.3568, exponent};
    const double rate = 0.8, h = 1e-5;
    check::relative("slope", curve.slope_over_rate(rate),
                    (curve.viscosity(rate + h) - curve.viscosity(rate - h)) / (2. * h * rate),
                    1e-8);
  }
  // Far from what moves, rates are so small that their squares are 0: n - 1 times
  // (time/rate)^a/rate^(2-a).
  const FlowCurve far{0.056, 0.00345, 3.313, 0.3568, 0.7};
  const double rate = 1e-170;
  check::relative("logarithm of the slope at a tiny rate", std::log(-far.slope_over_rate(rate)),
                  std::log(0.05255 * 0.6432) + 0.7 * std::log(3.313) - 1.3 * std::log(rate), 1e-12);
  check::absolute("slope at rest", blood.slope_over_rate(0.), 0., 0.);
}
} // namespace test_of_flow_curve
