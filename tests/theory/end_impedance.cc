// One impedance after the other is that of a list of frequencies, and conjugate at -f; of a narrow
// rigid tube the closed form, also of motions that grow or decay; and it is analytic across the
// axis of frequencies.

#include <continua/theory/end_impedance.h>

#include <continua/base/input_error.h>
#include <continua/theory/matched_impedance.h>

#include "waves.h"

#include "../unit_test.h"

namespace test_of_end_impedance
{
using namespace waves;

namespace
{
using Complex = std::complex<double>;

/// I_n(x)/(x/2)^n n! by its series.
Complex bessel(const unsigned int n, const Complex x)
{
  Complex sum = 0., term = 1.;
  for (unsigned int k = 0; k < 60; ++k)
  {
    sum += term;
    term *= 0.25 * x * x / ((k + 1.) * (k + 1. + n));
  }
  return sum;
}

/// rho s/(1 - F) U = -p', s p/K = -U' with F = 2 I_1(x)/(x I_0(x)), x = R sqrt(s rho/eta): exact
/// where waves are long beside the radius, up to the square of their ratio, here 1e-9.
void rigid_tube()
{
  constexpr double radius = 1e-3, density = 1000., bulk_modulus = 2.2e9, viscosity = 1e-3;
  TubeSection section;
  section.inner_radius = radius;
  section.fluid.density = density;
  section.fluid.shear.viscosity = viscosity;
  section.fluid.compression = Compression::elastic(1. / bulk_modulus);
  const EndImpedance impedance(section, WallEnd::absorbing, 1.);
  for (const Complex s : {Complex(0., 30.), Complex(20., 30.), Complex(25., 0.), Complex(-20., 30.),
                          Complex(-45., 20.)})
  {
    const Complex x = radius * std::sqrt(s * density / viscosity);
    const Complex slip = 1. - bessel(1, x) / bessel(0, x);
    const Complex exact =
        std::sqrt(density * bulk_modulus / slip) / (dealii::numbers::PI * radius * radius);
    check::absolute("a rigid tube", std::abs(impedance(s)(0, 0) / exact - 1.), 0., 3e-8);
  }
}

/// The value in the middle of a circle is the mean over the circle, which goes across the axis.
void mean_over_a_circle()
{
  const TubeSection section = tube(0.0125, 1e-4, 1000., 1.72e6, 0.49, 1000., 1e-3);
  const EndImpedance impedance(section, WallEnd::absorbing, 1.);
  const Complex middle(0., 40.);
  constexpr unsigned int n = 16;
  const auto centre = impedance(middle);
  for (unsigned int i = 0; i < 2; ++i)
  {
    Complex sum = 0.;
    for (unsigned int k = 0; k < n; ++k)
      sum += impedance(middle + std::polar(16., 2. * pi * (k + 0.5) / n))(i, i) / (1. * n);
    check::absolute("analytic across the axis", std::abs(sum / centre(i, i) - 1.), 0., 1e-5);
  }
}
} // namespace

UNIT_TEST(end_impedance)
{
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
        "a motion that decays at once", [&] { impedance(Complex(-1., 0.1)); }, "below 0.94");
  }
  rigid_tube();
  mean_over_a_circle();
}
} // namespace test_of_end_impedance
