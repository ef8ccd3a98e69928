#include <continua/theory/tube_waves_closed_form.h>

#include <continua/theory/womersley.h>

#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
/// The root x of x I1(x) / I0(x) = q with Re x > 0, by Newton's method.
Complex membrane_root(const Complex q)
{
  // The left side is x^2/2 - x^4/16 for small and x - 1/2 for large x.
  Complex x = std::abs(q) < 1.5 ? std::sqrt(2. * q * (1. + 0.25 * q)) : q + 0.5;
  for (unsigned int iteration = 0; iteration < 50; ++iteration)
  {
    const Complex ratio = bessel_i_ratio(1, x, 0, x);
    const Complex step = (x * ratio - q) / (x * (1. - ratio * ratio));
    x -= step;
    if (std::abs(step) <= 1e-14 * std::abs(x))
      return x;
  }
  throw std::runtime_error("The wave number of the membrane was not found.");
}

double square(const double x)
{
  return x * x;
}
} // namespace

Complex inviscid_membrane_wave_number(const ClosedFormTube &tube,
                                      const Complex omega,
                                      const Complex youngs_modulus)
{
  if (omega == Complex(0.))
    return 0.;
  const double radius = tube.tube.inner_radius;
  const Complex stiffness = youngs_modulus - tube.wall_density * square(radius) * omega * omega;
  if (!(stiffness.real() > 0.))
    throw std::domain_error("The frequency is above the ring frequency of the tube's wall: its "
                            "pressure wave does not propagate.");
  const Complex q = tube.tube.density * radius * square(radius) * omega * omega /
                    (tube.tube.wall_thickness * stiffness);
  return membrane_root(q) / radius;
}

Complex
membrane_wave_number(const ClosedFormTube &tube, const Complex omega, const Complex youngs_modulus)
{
  if (omega == Complex(0.))
    return 0.;
  const Womersley viscous(tube.tube.inner_radius, tube.tube.density, tube.viscosity);
  return inviscid_membrane_wave_number(tube, omega, youngs_modulus) /
         std::sqrt(viscous.one_minus_f10(omega));
}

Complex closed_form_wave_number(const ClosedFormTube &tube,
                                const Complex omega,
                                const Complex youngs_modulus,
                                const Anchoring anchoring)
{
  if (omega == Complex(0.))
    return 0.;
  const Womersley viscous(tube.tube.inner_radius, tube.tube.density, tube.viscosity);
  const Complex membrane = inviscid_membrane_wave_number(tube, omega, youngs_modulus);
  const Complex membrane_long = omega / moens_korteweg_speed(tube.tube, youngs_modulus);
  const Complex thick_long =
      omega / korteweg_speed(tube.tube, youngs_modulus, anchoring, WallTheory::thick);
  const double moving =
      anchoring == Anchoring::throughout ? 0. : 1. - square(1. - 0.5 * tube.tube.poissons_ratio);
  // 1 - a^2 F10 = (1 - F10) + (1 - a^2) F10.
  const Complex friction = viscous.one_minus_f10(omega) + moving * viscous.f10(omega);
  return thick_long * (membrane / membrane_long) / std::sqrt(friction);
}
} // namespace Continua
