// When the segregated loop ends: below its tolerance, at its cap, when it diverges.

#include "../unit_test.h"

#include <continua/base/input_error.h>
#include <continua/finite_volume/loop_monitor.h>

#include <cmath>
#include <limits>

namespace test_of_loop_monitor
{
using namespace Continua;

namespace
{
LoopCorrection correction(const double residual, const double magnitude)
{
  LoopCorrection result;
  result.residual = residual;
  result.magnitude = magnitude;
  return result;
}
} // namespace

UNIT_TEST(loop_monitor)
{
  LoopMonitor monitor(1e-3, 20);
  monitor.start();
  check::is_true("goes on above the tolerance", monitor.goes_on(correction(1e-2, 10.)));
  check::is_true("ends below it", !monitor.goes_on(correction(1e-4, 0.1)));
  check::is_true("has converged", monitor.converged());

  monitor.start();
  LoopCorrection open = correction(1e-4, 1.);
  open.continuity = 1e-2;
  check::is_true("continuity counts", monitor.goes_on(open));

  monitor.start();
  unsigned int n = 1;
  while (monitor.goes_on(correction(1e-2, 1.)))
    ++n;
  check::is_true("the cap", n == 20 && !monitor.converged());

  const auto diverge = [&](const double growth)
  {
    monitor.start();
    double magnitude = 1.;
    while (monitor.goes_on(correction(0.5, magnitude)))
      magnitude *= growth;
  };
  check::throws<RunError>(
      "slow growth", [&]() { diverge(1.1); }, "diverges; residuals.*Solution = coupled");
  check::throws<RunError>(
      "fast growth", [&]() { diverge(200.); }, "diverges");
  check::throws<RunError>(
      "no number",
      [&]()
      {
        monitor.start();
        monitor.goes_on(correction(std::numeric_limits<double>::quiet_NaN(), 1.));
      },
      "diverges");
  // A residual that goes up and down while it falls does not diverge.
  monitor.start();
  double magnitude = 1.;
  for (unsigned int i = 0; i < 15; ++i)
    monitor.goes_on(correction(1e-2, magnitude *= i % 3 == 0 ? 0.1 : 1.5));
  check::is_true("ups and downs", !monitor.converged());
}
} // namespace test_of_loop_monitor
