// Bessel functions of complex argument against mpmath with 60 digits (besselj, besseli of the
// arguments as they are represented in double precision), among them zeros, tiny and huge
// arguments.

#include <continua/theory/complex_bessel.h>

#include "../unit_test.h"

#include <limits>

namespace test_of_complex_bessel
{
using namespace Continua;

namespace
{
void close(const std::string &name, const Complex value, const Complex reference)
{
  check::absolute(name, std::abs(value - reference) / std::abs(reference), 0., 1e-14);
}
} // namespace

UNIT_TEST(complex_bessel)
{
  close("J0, small", bessel_j(0, {0.001, -0.002}),
        {1.0000007499998906249, 1.0000003750000191389e-6});
  close("J1, tiny", bessel_j(1, {1e-12, 1e-12}),
        {4.9999999999999998994e-13, 4.9999999999999998994e-13});
  // The argument is the zero rounded to double precision, so the value tells the rounding error.
  close("J0 at its first zero", bessel_j(0, 2.404825557695773), -6.1087652597367303971e-17);
  close("J1 beside its first zero", bessel_j(1, {3.8317059702075125, 1e-10}),
        {-6.1498599131407630687e-17, -4.0275939570255297072e-11});
  close("J2, complex", bessel_j(2, {20., -15.}),
        {-1.8282706931904169773e+5, -1.6972271036542813253e+5});
  close("J0 of 100", bessel_j(0, 100.), 1.9985850304223122424e-2);
  close("J1, large", bessel_j(1, {-7., 400.}),
        {-6.7670273173132835593e+171, 7.9035664967254393323e+171});
  check::is_true("J0 of 0", bessel_j(0, 0.) == 1. && bessel_j(3, 0.) == 0.);

  // 1000 i^(3/2), the argument in double precision.
  const Complex stokes(-7.0710678118654755e+2, 7.0710678118654755e+2);
  close("J1/J0 of 1000 i^1.5", bessel_j_ratio(1, stokes, 0, stokes),
        {-3.5367847898133308519e-4, 9.9964644669799067366e-1});
  close("J1/J0, small", bessel_j_ratio(1, {1e-3, -1e-3}, 0, {1e-3, -1e-3}),
        {4.9999987499995834376e-4, -5.0000012499995834373e-4});
  close("J0/J1, numerator and denominator beyond double",
        bessel_j_ratio(0, {400., 2000.}, 1, {410., 2001.}),
        {-1.9961539528198336255e-1, 3.0943617287673731598e-1});
  close("J2/J0, e^50000", bessel_j_ratio(2, {5e4, -5e4}, 0, {5.001e4, -5e4}),
        {8.391347797628713434e-1, -5.4397869782894390795e-1});
  close("J0/J1 at a zero of J0", bessel_j_ratio(0, 2.404825557695773, 1, 2.404825557695773),
        -1.1766916515308941509e-16);
  close("J1/J0, two arguments", bessel_j_ratio(1, {12.5, -7.}, 0, {13., -6.}),
        {-1.1132480208925217295, -2.4324857276323166116});
  close("I1/I0", bessel_i_ratio(1, {5000., 3.}, 0, {5001., 2.}),
        {1.9879704776559329133e-1, 3.0953998036867985306e-1});
  close("I0/I1, small", bessel_i_ratio(0, 0.01, 1, {0., 0.02}), {0., -1.000075003073015173e+2});

  check::throws<std::domain_error>(
      "0 below", [] { bessel_j_ratio(0, 1., 1, 0.); }, "denominator");
  check::throws<std::domain_error>(
      "not finite", [] { bessel_j(0, std::numeric_limits<double>::quiet_NaN()); }, "not finite");
  check::throws<std::domain_error>(
      "too large",
      [] {
        bessel_j(0, {0., 1000.});
      },
      "too large");
}
} // namespace test_of_complex_bessel
