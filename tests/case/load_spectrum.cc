// What drives a body, over frequency: a sine squared pulse, whose spectrum is known in closed form.

#include <continua/case/before_the_run/load_spectrum.h>

#include "../unit_test.h"

#include <cmath>

namespace test_of_load_spectrum
{
using namespace Continua;

UNIT_TEST(load_spectrum)
{
  constexpr double pi = 3.14159265358979323846, duration = 0.05;
  Problem problem;
  check::is_true("nothing drives", LoadSpectrum(problem, 1., 1e-3).is_empty());
  problem.conditions.resize(2);
  // A jump at t = 0, held for 1 s and faded out over half a second: 1/(2 pi f) over an area of
  // 1.25 s, at a frequency of the transform of 2048 samples.
  Problem constant = problem;
  constant.conditions[0].normal.along_normal = Waveform(3.);
  check::relative("a constant load is a jump", LoadSpectrum(constant, 1., 1e-3).from(31.25),
                  1. / (2. * pi * 31.25 * 1.25), 0.02);

  problem.conditions[1].normal.along_normal =
      Waveform(Expression("if(t < 0.05, 7*sin(pi*t/0.05)^2, 0)", Dimensions::pressure));
  const LoadSpectrum spectrum(problem, 1., 1e-3);
  check::relative("from zero", spectrum.from(0.), 1., 1e-9);
  // |sin(x)/(x (1 - (x/pi)^2))|, x = pi f T, falls up to f = 2/T.
  for (const double frequency : {8., 16., 24.})
  {
    const double x = pi * frequency * duration;
    check::absolute("at " + std::to_string(static_cast<int>(frequency)) + " Hz",
                    spectrum.from(frequency), std::sin(x) / (x * (1. - x * x / (pi * pi))), 0.02);
  }
  // Beyond, its lobes fall as 1/(pi (f T)^3): to a thousandth at 6.8/T, within the lobe there.
  check::absolute("highest frequency [Hz]", spectrum.highest_frequency(), 6.8 / duration, 10.);
  check::relative("of its energy", spectrum.energy_frequency(), 0.95 / duration, 0.05);
}
} // namespace test_of_load_spectrum
