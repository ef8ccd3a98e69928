#include <continua/theory/womersley.h>

#include <continua/theory/constants.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace Continua
{
using dealii::numbers::PI;

Womersley::Womersley(const double radius, const double density, const double viscosity)
    : radius(radius), density(density), viscosity(viscosity)
{
  if (!(radius > 0.) || !(density > 0.) || !(viscosity >= 0.))
    throw std::invalid_argument(
        "Womersley: radius and density must be positive, viscosity not negative");
}

double Womersley::area() const
{
  return PI * radius * radius;
}

double Womersley::number(const double omega) const
{
  return radius * std::sqrt(omega * density / viscosity);
}

double Womersley::layer_thickness(const double omega) const
{
  return std::sqrt(2. * viscosity / (density * omega));
}

Complex Womersley::stokes_argument(const Complex omega) const
{
  // z^2 = i^3 alpha^2; every function here is even in z.
  return std::sqrt(-imaginary * omega * density / viscosity) * radius;
}

Complex Womersley::f10(const Complex omega) const
{
  if (viscosity == 0.)
    return 0.;
  const Complex z = stokes_argument(omega);
  return z == Complex(0.) ? 1. : 2. * bessel_j_ratio(1, z, 0, z) / z;
}

Complex Womersley::one_minus_f10(const Complex omega) const
{
  if (viscosity == 0.)
    return 1.;
  const Complex z = stokes_argument(omega);
  return -bessel_j_ratio(2, z, 0, z);
}

Complex Womersley::wave_number(const Complex omega, const Complex long_wave_speed) const
{
  return omega / (long_wave_speed * std::sqrt(one_minus_f10(omega)));
}

Complex
Womersley::velocity(const Complex omega, const Complex pressure_gradient, const double r) const
{
  if (omega == Complex(0.))
    return -pressure_gradient * (radius * radius - r * r) / (4. * viscosity);
  const Complex inviscid = imaginary * pressure_gradient / (density * omega);
  if (viscosity == 0.)
    return inviscid;
  const Complex z = stokes_argument(omega);
  return inviscid * (1. - bessel_j_ratio(0, z * (r / radius), 0, z));
}

Complex Womersley::profile(const Complex omega, const double r) const
{
  if (viscosity == 0.)
    return 1.;
  return velocity(omega, 1., r) * area() / flow_rate(omega, 1.);
}

Complex Womersley::flow_rate(const Complex omega, const Complex pressure_gradient) const
{
  if (omega == Complex(0.))
    return -pressure_gradient * area() * radius * radius / (8. * viscosity);
  return imaginary * pressure_gradient * area() / (density * omega) * one_minus_f10(omega);
}

Complex Womersley::wall_shear_stress(const Complex omega, const Complex pressure_gradient) const
{
  return -0.5 * radius * pressure_gradient * f10(omega);
}

Complex Womersley::characteristic_impedance(const Complex omega, const Complex wave_number) const
{
  return density * omega / (wave_number * area() * one_minus_f10(omega));
}

double phase_speed(const double omega, const Complex wave_number)
{
  return omega / wave_number.real();
}

double attenuation(const Complex wave_number)
{
  return -wave_number.imag();
}
} // namespace Continua
