#include <continua/theory/matched_impedance.h>

#include <continua/theory/dispersion_curves.h>
#include <continua/theory/scaled_system.h>

#include <deal.II/base/numbers.h>

namespace Continua
{
using dealii::numbers::PI;

namespace
{
using Complex = std::complex<double>;
} // namespace

dealii::FullMatrix<Complex> matched_impedance(const std::vector<WaveMode> &modes,
                                              const WallEnd wall,
                                              const Complex &omega,
                                              const double wall_area)
{
  const unsigned int n_families = modes.size();
  const unsigned int n_ports = n_families > 3 && wall == WallEnd::absorbing ? 2 : 1;
  const std::vector<WaveMode::Junction> zeros = zero_quantities(wall, n_families);

  // The backward waves after the first n_ports families, so that the end has its zeros.
  const unsigned int n_backward = n_families - n_ports;
  ComplexMatrix backward(n_backward, n_ports);
  if (n_backward > 0)
  {
    ComplexMatrix system(n_backward, n_backward), right(n_backward, n_ports);
    for (unsigned int i = 0; i < n_backward; ++i)
    {
      for (unsigned int j = 0; j < n_backward; ++j)
        system(i, j) = WaveMode::parity[zeros[i]] * modes[n_ports + j].junction[zeros[i]];
      for (unsigned int j = 0; j < n_ports; ++j)
        right(i, j) = -modes[j].junction[zeros[i]];
    }
    backward = solve_scaled(system, right);
  }
  const auto at_end = [&](const unsigned int wave, const WaveMode::Junction quantity)
  {
    Complex sum = modes[wave].junction[quantity];
    for (unsigned int j = 0; j < n_backward; ++j)
      sum += WaveMode::parity[quantity] * backward(j, wave) * modes[n_ports + j].junction[quantity];
    return sum;
  };

  // Z Q = P, transposed to one right side a row.
  ComplexMatrix flows(n_ports, n_ports), pressures(n_ports, n_ports);
  for (unsigned int wave = 0; wave < n_ports; ++wave)
  {
    flows(wave, 0) = at_end(wave, WaveMode::flow_rate);
    pressures(wave, 0) = at_end(wave, WaveMode::traction);
    if (n_ports > 1)
    {
      flows(wave, 1) =
          wall_area * Complex(0., 1.) * omega * at_end(wave, WaveMode::axial_displacement);
      pressures(wave, 1) = -at_end(wave, WaveMode::axial_force) / wall_area;
    }
  }
  const ComplexMatrix transposed = solve_scaled(flows, pressures);
  dealii::FullMatrix<Complex> impedance(n_ports, n_ports);
  for (unsigned int i = 0; i < n_ports; ++i)
    for (unsigned int j = 0; j < n_ports; ++j)
      impedance(i, j) = 0.5 * (transposed(i, j) + transposed(j, i));
  return impedance;
}

std::vector<dealii::FullMatrix<Complex>> matched_impedances(const TubeSection &section,
                                                            const WallEnd wall,
                                                            const double shift,
                                                            const std::vector<double> &frequencies)
{
  const DispersionCurves curves(section, shift, frequencies);
  std::vector<dealii::FullMatrix<Complex>> impedances;
  std::vector<WaveMode> modes;
  for (const double frequency : frequencies)
  {
    curves.evaluate(frequency, modes);
    impedances.push_back(
        matched_impedance(modes, wall, Complex(2. * PI * frequency, -shift), section.wall_area()));
  }
  return impedances;
}
} // namespace Continua
