// One impedance after the other is that of a list of frequencies, and conjugate at -f.

#include <continua/theory/end_impedance.h>

#include <continua/base/input_error.h>
#include <continua/theory/matched_impedance.h>

#include "waves.h"

#include "../unit_test.h"

namespace test_of_end_impedance
{
using namespace waves;

UNIT_TEST(end_impedance)
{
  using Complex = std::complex<double>;
  const TubeSection section = tube(0.0125, 1e-4, 1000., 1.72e6, 0.49, 1000., 1e-3);
  const std::vector<double> frequencies = {2., 4., 8., 16.};
  for (const double shift : {0., 3.})
  {
    const auto reference = matched_impedances(section, WallEnd::absorbing, shift, frequencies);
    const EndImpedance impedance(section, WallEnd::absorbing, 4.);
    double error = 0., conjugate = 0.;
    for (const unsigned int k : {3, 0})
    {
      const auto value = impedance({shift, 2. * pi * frequencies[k]});
      const auto other = impedance({shift, -2. * pi * frequencies[k]});
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
        {
          error = std::max(error, std::abs(value(i, j) / (4. * reference[k](i, j)) - 1.));
          conjugate = std::max(conjugate, std::abs(other(i, j) / std::conj(value(i, j)) - 1.));
        }
    }
    check::absolute("four times the impedance of the list", error, 0., 1e-9);
    check::absolute("conjugate at -f", conjugate, 0., 1e-15);
    check::throws<RunError>(
        "a motion that decays", [&] { impedance(Complex(-1., 5.)); }, "do not decay");
  }
}
} // namespace test_of_end_impedance
