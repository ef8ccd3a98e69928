// The amplification of one mode against the formulas of doc/numerics.md and against
// characteristic polynomials derived by hand.

#include <continua/theory/amplification.h>

#include "../unit_test.h"

namespace test_of_amplification
{
using namespace Continua;

namespace
{
const double dt = 1e-3;

Amplification of(const Step &step, const double theta)
{
  return Amplification(step, theta / dt);
}
Step euler(const Update update)
{
  return euler_step(0., dt, update);
}
Step backward(const Update update)
{
  return backward_differencing_step(0., dt, dt, update);
}
} // namespace

UNIT_TEST(amplification)
{
  for (const double theta : {1e-3, 0.1, 1., 3.9})
  {
    const std::string name = ", theta " + std::to_string(theta);
    check::relative("Euler, implicit" + name, of(euler(Update::implicit), theta).spectral_radius(),
                    1. / std::sqrt(1. + theta * theta), 2e-15);
    check::relative("Euler, trapezoidal" + name,
                    of(euler(Update::trapezoidal), theta).spectral_radius(),
                    1. / std::sqrt(1. + 0.5 * theta * theta), 2e-15);
    check::relative("Crank-Nicolson" + name,
                    of(crank_nicolson_step(0., dt), theta).spectral_radius(), 1., 2e-15);
    // (3 G^2 - 4 G + 1)/2 = i theta G^2 for both U and omega D.
    const Complex root = (2. + std::sqrt(Complex(1., 2. * theta))) / Complex(3., -2. * theta);
    check::relative("backward differencing, implicit" + name,
                    of(backward(Update::implicit), theta).spectral_radius(), std::abs(root), 1e-14);
    if (theta < 3.)
      check::absolute("backward differencing, implicit, principal" + name,
                      std::abs(of(backward(Update::implicit), theta).principal() - root), 0.,
                      1e-14);
  }
  // Beyond theta = 4, with x = theta^2/2: (1 + x) G^2 - (2 - x) G + 1 = 0 has real roots.
  for (const double theta : {10., 100.})
  {
    const double x = 0.5 * theta * theta;
    const double root = std::sqrt((2. - x) * (2. - x) - 4. * (1. + x));
    check::relative("Euler, trapezoidal, theta " + std::to_string(theta),
                    of(euler(Update::trapezoidal), theta).spectral_radius(),
                    (x - 2. + root) / (2. * (1. + x)), 1e-13);
    check::absolute("it alternates, theta " + std::to_string(theta),
                    std::arg(of(euler(Update::trapezoidal), theta).factors().front()),
                    3.14159265358979, 1e-12);
  }
  // (3 G^2 - 4 G + 1)(G - 1) + theta^2 G^2 (G + 1) = 0; the largest root by
  // numpy.roots([3 + t*t, -7 + t*t, 5, -1]).
  check::relative("backward differencing, trapezoidal, 10",
                  of(backward(Update::trapezoidal), 10.).spectral_radius(), 0.8303719694374934,
                  1e-13);
  check::relative("backward differencing, trapezoidal, 100",
                  of(backward(Update::trapezoidal), 100.).spectral_radius(), 0.9983993576897342,
                  1e-13);

  // An oscillation of the thesis's beam, doc/numerics.md: 0.99669; 30 s: 0.7155.
  const Amplification beam(euler_step(0., 1e-4, Update::trapezoidal), 2. * M_PI * 3.3627);
  check::absolute("beam, an oscillation", beam.remaining(1. / 3.3627), 0.99669, 5e-6);
  check::absolute("beam, 30 s", beam.remaining(30.), 0.7155, 5e-5);
  // Crank-Nicolson: tan(arg/2) = theta/2.
  check::relative("frequency error", of(crank_nicolson_step(0., dt), 0.5).frequency_error(),
                  2. * std::atan(0.25) / 0.5 - 1., 1e-12);
}
} // namespace test_of_amplification
