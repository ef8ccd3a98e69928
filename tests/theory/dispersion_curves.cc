// Waves followed over frequency: what is interpolated is a root, and each family stays itself in a
// thick wall, around blood, and in a steel pipe.

#include <continua/theory/dispersion_curves.h>

#include "waves.h"

#include "../unit_test.h"

namespace test_of_dispersion_curves
{
using namespace waves;

namespace
{
using Complex = std::complex<double>;

double relative_difference(const Complex a, const Complex b)
{
  return std::abs(a - b) / std::abs(b);
}

void follow(const std::string &name,
            const TubeSection &section,
            const double shift,
            const double highest,
            const double axial_speed)
{
  const DispersionCurves curves(section, shift, highest);
  const ExactDispersion exact(section);
  std::vector<WaveMode> modes;
  double worst = 0., axial_error = 0., previous = 0.;
  bool distinct = true;
  for (const double share : {0.03, 0.1, 0.3, 0.5, 0.7, 0.85, 0.99})
  {
    const double frequency = share * highest;
    const Complex omega(2. * pi * frequency, -shift);
    curves.evaluate(frequency, modes);
    for (std::size_t i = 0; i < modes.size(); ++i)
    {
      Complex root;
      if (!exact.find_root(omega, modes[i].wave_number, root))
        worst = 1e300;
      worst = std::max(worst, relative_difference(modes[i].wave_number, root));
      for (std::size_t j = 0; j < i; ++j)
        distinct = distinct && relative_difference(modes[j].wave_number, root) > 0.05;
    }
    // Phase speed of the axial wave, and pressure over flow of the pressure wave.
    axial_error = std::max(axial_error,
                           std::abs(omega.real() / modes[1].wave_number.real() / axial_speed - 1.));
    distinct = distinct && omega.real() / modes[0].wave_number.real() > 0. &&
               modes[0].wave_number.real() > previous;
    previous = modes[0].wave_number.real();
  }
  check::absolute(name + ", interpolated roots", worst, 0., 1e-4);
  check::absolute(name + ", speed of the axial wave", axial_error, 0., 0.12);
  check::is_true(name + ", families are distinct", distinct);
}
} // namespace

UNIT_TEST(dispersion_curves)
{
  // Bar speeds sqrt(Y/rho) of the wall; the pull of the liquid changes them little.
  follow("thick wall", tube(12.5e-3, 4e-3, 880., 1.72e6, 0.49, 998., 1e-3), 28., 300.,
         std::sqrt(1.72e6 / 880.));
  follow("blood", tube(10e-3, 1e-3, 1100., 1e6, 0.45, 1060., 4e-3), 20., 100.,
         std::sqrt(1e6 / 1100.));
  TubeSection steel = tube(0.1, 5e-3, 7850., 200e9, 0.3, 998., 1e-3);
  steel.fluid.compression = Compression::elastic(1. / 2.2e9);
  follow("steel", steel, 500., 2000., std::sqrt(200e9 / 7850.));
}
} // namespace test_of_dispersion_curves
