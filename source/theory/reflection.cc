#include <continua/theory/reflection.h>

#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
/// exp(-i k distance)
Complex phase(const Complex wave_number, const double distance)
{
  return std::exp(Complex(0., -1.) * wave_number * distance);
}

Complex admittance_of(const std::vector<Complex> &branches)
{
  Complex sum = 0.;
  for (const Complex branch : branches)
    sum += 1. / branch;
  return sum;
}
} // namespace

Complex characteristic_impedance(const double density, const Complex speed, const double area)
{
  return density * speed / area;
}

Complex reflection_coefficient(const Complex impedance, const Complex load)
{
  if (std::isinf(load.real()) || std::isinf(load.imag()))
    return 1.;
  return (load - impedance) / (load + impedance);
}

Complex junction_reflection(const Complex impedance, const std::vector<Complex> &branches)
{
  // In admittances, so that no branch at all is a closed end.
  const Complex loss = impedance * admittance_of(branches);
  return (1. - loss) / (1. + loss);
}

Complex junction_transmission(const Complex impedance, const std::vector<Complex> &branches)
{
  return 2. / (1. + impedance * admittance_of(branches));
}

Complex Resonator::series() const
{
  const Complex sum = 1. - near_reflection * far_reflection * phase(wave_number, 2. * length);
  if (std::abs(sum) < 1e-14)
    throw std::domain_error("The tube is in resonance, and nothing damps it.");
  return sum;
}

Complex Resonator::pressure(const double z, const Complex entering) const
{
  return entering * (phase(wave_number, z) + far_reflection * phase(wave_number, 2. * length - z)) /
         series();
}

Complex Resonator::flow_rate(const double z, const Complex entering) const
{
  return entering / impedance *
         (phase(wave_number, z) - far_reflection * phase(wave_number, 2. * length - z)) / series();
}

Complex Resonator::input_impedance(const double z) const
{
  const Complex reflected = far_reflection * phase(wave_number, 2. * (length - z));
  return impedance * (1. + reflected) / (1. - reflected);
}

Complex Resonator::pressure_of_prescribed(const double z, const Complex inlet_pressure) const
{
  const Complex reflected = far_reflection * phase(wave_number, 2. * length);
  if (std::abs(1. + reflected) < 1e-14)
    throw std::domain_error("The tube is in resonance, and nothing damps it.");
  return inlet_pressure *
         (phase(wave_number, z) + far_reflection * phase(wave_number, 2. * length - z)) /
         (1. + reflected);
}
} // namespace Continua
