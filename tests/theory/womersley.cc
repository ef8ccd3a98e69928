// Womersley's flow against scripts/references/waves/closed_form_theory.py (mpmath: the profile from
// modified Bessel functions, its mean by quadrature) and against its limits.

#include <continua/theory/womersley.h>

#include "../unit_test.h"

#include <stdexcept>

namespace test_of_womersley
{
using namespace Continua;

namespace
{
void close(const std::string &name, const Complex value, const Complex reference)
{
  check::absolute(name, std::abs(value - reference) / std::abs(reference), 0., 1e-13);
}

const double radius = 0.0125, density = 998., viscosity = 1e-3;
const Complex gradient(2., -3.);
const Womersley flow(radius, density, viscosity);

void at(const std::string &name,
        const Complex omega,
        const Complex one_minus_f10,
        const Complex velocity,
        const Complex flow_rate,
        const Complex shear,
        const Complex wave_number)
{
  close(name + ", 1 - F10", flow.one_minus_f10(omega), one_minus_f10);
  close(name + ", F10", flow.f10(omega), 1. - one_minus_f10);
  close(name + ", velocity", flow.velocity(omega, gradient, 0.5 * radius), velocity);
  close(name + ", flow rate", flow.flow_rate(omega, gradient), flow_rate);
  close(name + ", wall shear stress", flow.wall_shear_stress(omega, gradient), shear);
  close(name + ", wave number", flow.wave_number(omega, {2.6, 0.1}), wave_number);
}
} // namespace

UNIT_TEST(womersley)
{
  at("2/s", 2., {0.91988505602257364, 0.07684180135663925},
     {0.0014989523547305821, 0.0009990991343023645}, {6.4088341723927621e-7, 5.0914525803066897e-7},
     {0.00043934697571915642, 0.0024626777165347349}, {0.79747803069441094, -0.064025319219186801});
  at("125/s", 125., {0.98987051137325471, 0.010078055447210805},
     {2.404809619238477e-5, 1.6032064128256513e-5}, {1.1605695753626391e-8, 7.9089720540293862e-9},
     {6.2344931800886417e-5, 0.00031590360484160934}, {48.23958698726028, -2.1013418776925096});
  at("complex frequency", {125., -7.}, {0.98960219687714662, 0.0097832563608280493},
     {2.3077928218309785e-5, 1.7324428108481861e-5}, {1.1127363678567232e-8, 8.5265128799091051e-9},
     {5.3463517729858614e-5, 0.00031724951306385158}, {48.12921462514673, -4.7963153441572935});
  // Where the difference 1 - F10 would have lost 7 digits.
  close("slow, 1 - F10", flow.one_minus_f10(1e-6), {5.0659383101450017e-10, 1.9492187486422395e-5});
  close("slow, flow rate", flow.flow_rate(1e-6, gradient),
        {-1.9174012319186088e-5, 2.8762638096839651e-5});

  // Poiseuille: -dp/dz (R^2 - r^2)/(4 eta) = -dp/dz 0.029296875 m/s at R/2, pi R^4 / (8 eta).
  close("Poiseuille, velocity", flow.velocity(0., gradient, 0.5 * radius), -gradient * 0.029296875);
  close("Poiseuille, flow rate", flow.flow_rate(0., gradient), -gradient * 9.587379924285259e-06);
  close("Poiseuille, wall shear stress", flow.wall_shear_stress(0., gradient), -gradient * 0.00625);
  close("Poiseuille, profile", flow.profile(0., 0.5 * radius), 1.5);
  close("profile is velocity over mean", flow.profile(2., 0.5 * radius),
        Complex(0.0014989523547305821, 0.0009990991343023645) * 3.14159265358979324 * radius *
            radius / Complex(6.4088341723927621e-7, 5.0914525803066897e-7));
  close("no slip", 1. + flow.profile(2., radius), 1.);

  // I1(q)/I0(q) = 1 - 1/(2q) - 1/(8q^2) - ... with q = i^(1/2) alpha, and F10 is 2/q times it.
  const double alpha = flow.number(1e6);
  check::relative("Womersley number", alpha, 12487.493743742176, 1e-14);
  const Complex s = alpha * std::sqrt(Complex(0., 1.));
  check::absolute("large alpha", std::abs(flow.f10(1e6) - 2. / s * (1. - 0.5 / s)), 0., 1e-12);
  // sqrt(2 nu / omega) = 0.14156 mm at 100/s.
  check::relative("layer", flow.layer_thickness(100.), 1.415629900797544e-4, 1e-14);

  const Womersley inviscid(radius, density, 0.);
  close("inviscid, wave number", inviscid.wave_number(10., 5.), 2.);
  close("inviscid, impedance", inviscid.characteristic_impedance(10., 2.),
        density * 5. / (3.14159265358979324 * radius * radius));
  // rho i omega Q = -dp/dz A (1 - F10) with dp/dz = -i k p.
  const Complex k = flow.wave_number(125., 2.6);
  close("impedance is pressure over flow", flow.characteristic_impedance(125., k),
        1. / flow.flow_rate(125., Complex(0., -1.) * k));
  close("inviscid, profile", inviscid.profile(10., 0.001), 1.);

  check::relative("phase speed", phase_speed(12., {4., -1.}), 3., 1e-15);
  check::relative("attenuation", attenuation({4., -1.}), 1., 1e-15);
  check::throws<std::invalid_argument>(
      "no radius", [] { Womersley(0., 1., 1.); }, "radius");
}
} // namespace test_of_womersley
