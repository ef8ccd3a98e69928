// The law of the density: its derivatives against differences, and the closed laws of three
// exponents.

#include <continua/materials/volume_law.h>

#include <cmath>

#include "../unit_test.h"

namespace test_of_volume_law
{
using namespace Continua;

UNIT_TEST(volume_law)
{
  for (const double exponent : {0., 1., 7.15, -1.})
  {
    const VolumeLaw law{1. / 20., exponent, 2.};
    const std::string name = "exponent " + std::to_string(exponent);
    const double p = 3.5, h = 1e-5;
    check::relative(name + ": density at p0", law.density_ratio(2.), 1., 1e-15);
    check::relative(name + ": compressibility", law.compressibility(p),
                    (law.density_ratio(p + h) - law.density_ratio(p - h)) /
                        (2. * h * law.density_ratio(p)),
                    1e-9);
    check::absolute(name + ": slope", law.compressibility_slope(p),
                    (law.compressibility(p + h) - law.compressibility(p - h)) / (2. * h), 1e-10);
  }
  // The thesis's equation of state (2.28): p - p0 = K (rho/rho0 - 1); and p - p0 = -K (J - 1).
  check::relative("exponent 1", VolumeLaw{1. / 20., 1., 2.}.density_ratio(3.5), 1. + 1.5 / 20.,
                  1e-15);
  check::relative("exponent -1", 1. / VolumeLaw{1. / 20., -1., 2.}.density_ratio(3.5),
                  1. - 1.5 / 20., 1e-15);
  check::relative("exponent 0", VolumeLaw{1. / 20., 0., 2.}.density_ratio(3.5), std::exp(1.5 / 20.),
                  1e-15);
  // The law of a small exponent is next to that of exponent 0: (1 + n x)^(1/n) = exp(x (1 - n
  // x/2)).
  for (const double exponent : {1e-6, 1e-12, 1e-17, -1e-17})
    check::relative("a small exponent", VolumeLaw{1. / 20., exponent, 2.}.density_ratio(3.5),
                    std::exp(1.5 / 20. * (1. - 0.5 * exponent * 1.5 / 20.)), 1e-14);
  // Energy: the power of the pressure against a change of volume, d(e/rho) = p c/rho dp; closed
  // forms where they have digits; and half of p^2/K where pressures are small.
  for (const double exponent : {0., 1., 7.15, -1.})
  {
    const VolumeLaw law{1. / 20., exponent, 2.};
    const std::string name = "exponent " + std::to_string(exponent);
    const double p = 3.5, h = 1e-4;
    const auto specific = [&](const double q) { return law.energy(q) / law.density_ratio(q); };
    check::relative(name + ": energy's rate", (specific(p + h) - specific(p - h)) / (2. * h),
                    p * law.compressibility(p) / law.density_ratio(p), 1e-8);
    check::absolute(name + ": no energy at p0", law.energy(2.), 0., 0.);
    const VolumeLaw water{1. / 2.2e9, exponent, 0.};
    check::relative(name + ": energy of a small pressure", water.energy(1e3), 0.5e6 / 2.2e9, 1e-5);
  }
  check::relative("exponent 0: energy", VolumeLaw{1. / 20., 0., 0.}.energy(9.),
                  20. * std::expm1(9. / 20.) - 9., 1e-13);
  check::relative("exponent 1: energy", VolumeLaw{1. / 20., 1., 0.}.energy(9.),
                  29. * std::log(29. / 20.) - 9., 1e-13);
  check::absolute("incompressible: energy", VolumeLaw{}.energy(1e9), 0., 0.);
  check::absolute("incompressible", VolumeLaw{}.compressibility(1e9), 0., 0.);
  check::relative("incompressible: density", VolumeLaw{}.density_ratio(1e9), 1., 1e-15);
  check::is_true("too low a pressure", VolumeLaw{1. / 20., 1., 2.}.stiffening(-19.) < 0.);
}
} // namespace test_of_volume_law
