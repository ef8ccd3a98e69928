#include <continua/continuum/harmonic_system.h>

namespace Continua
{
namespace
{
using Complex = std::complex<double>;

/// An empty vector stands for zeros.
void add_scaled(const Complex factor, const std::vector<Complex> &from, std::vector<Complex> &to)
{
  if (from.empty())
    return;
  to.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i)
    to[i] += factor * from[i];
}
} // namespace

void HarmonicLoad::add(const Complex factor, const HarmonicLoad &other)
{
  add_scaled(factor, other.forces, forces);
  add_scaled(factor, other.velocities, velocities);
  add_scaled(factor, other.ports, ports);
  add_scaled(factor, other.dilatations, dilatations);
}

void HarmonicSolution::add(const Complex factor, const HarmonicSolution &other)
{
  add_scaled(factor, other.displacement, displacement);
  add_scaled(factor, other.pressure, pressure);
  add_scaled(factor, other.port_pressures, port_pressures);
  add_scaled(factor, other.port_flow_rates, port_flow_rates);
}

double HarmonicPowers::taken() const
{
  double sum = 0.;
  for (const HarmonicPower &region : regions)
    sum += region.sum();
  for (const double port : ports)
    sum += port;
  return sum;
}
} // namespace Continua
