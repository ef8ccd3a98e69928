// dx/dt = U - x/tau with U = 3 + 7 t: x = C exp(-t/tau) + tau (3 + 7 (t - tau)).

#include <continua/time_integration/linear_relaxation.h>

#include <cmath>

#include "../unit_test.h"

namespace test_of_linear_relaxation
{
using namespace Continua;

UNIT_TEST(linear_relaxation)
{
  const double tau = 0.2, start = 5.;
  for (const double ratio : {1e-2, 0.5, 3., 40.})
  {
    const double step = ratio * tau, constant = start - tau * (3. - 7. * tau),
                 exact = constant * std::exp(-ratio) + tau * (3. + 7. * (step - tau));
    const LinearRelaxation found(step, tau);
    check::relative("x after " + std::to_string(ratio) + " relaxation times",
                    found.decay * start + found.of_old * 3. + found.of_new * (3. + 7. * step),
                    exact, 1e-12);
  }
  // A short step: x tau/2 (1 - x/3 + ...) and x tau/2 (1 - 2 x/3 + ...).
  const LinearRelaxation found(1e-6 * tau, tau);
  check::relative("short step: of the new rate", found.of_new, 0.5e-6 * tau * (1. - 1e-6 / 3.),
                  1e-12);
  check::relative("short step: of the old rate", found.of_old, 0.5e-6 * tau * (1. - 2e-6 / 3.),
                  1e-12);
}
} // namespace test_of_linear_relaxation
