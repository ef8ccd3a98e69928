#include <continua/finite_element/solvers/harmonic_ledger.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

template <int dim>
std::vector<std::complex<double>> HarmonicLedger<dim>::reactions(const HarmonicSolution &solution,
                                                                 const HarmonicLoad &load)
{
  std::vector<Complex> forces, dilatations;
  equations.apply(equations.coefficients(solution.s), solution.displacement, solution.pressure,
                  forces, dilatations);
  for (std::size_t i = 0; i < load.forces.size(); ++i)
    forces[i] -= load.forces[i];
  for (unsigned int port = 0; port < ports.size(); ++port)
    equations.add_port(port, solution.port_pressures[port], forces);
  return forces;
}

template <int dim>
std::complex<double> HarmonicLedger<dim>::power_of(const HarmonicLoad &part,
                                                   const HarmonicSolution &solution,
                                                   const HarmonicLoad &load)
{
  Complex of_rank = 0.;
  const Complex s = solution.s;
  for (std::size_t i = 0; i < part.forces.size(); ++i)
    of_rank += part.forces[i] * std::conj(s * solution.displacement[i]);
  if (!part.velocities.empty() && equations.size_of(part.velocities) > 0.)
  {
    const std::vector<Complex> of_supports = reactions(solution, load);
    for (std::size_t i = 0; i < of_supports.size(); ++i)
      of_rank += of_supports[i] * std::conj(part.velocities[i]);
  }
  Complex power = 0.5 * equations.sum(of_rank);
  for (unsigned int port = 0; port < part.ports.size(); ++port)
    power += ports.is_free_flow(port)
                 ? 0.5 * solution.port_pressures[port] * std::conj(part.ports[port])
                 : -0.5 * part.ports[port] * std::conj(solution.port_flow_rates[port]);
  return power;
}

template <int dim>
HarmonicPowers HarmonicLedger<dim>::powers(const HarmonicSolution &solution,
                                           const HarmonicLoad &load)
{
  const double omega = solution.s.imag();
  const HarmonicCoefficients at_s = equations.coefficients(solution.s);
  RealAndImaginary u(space.velocity_vector()), p(space.pressure_vector());
  u.set(solution.displacement);
  p.set(solution.pressure);
  DistributedVector velocity_work = space.velocity_vector(),
                    pressure_work = space.pressure_vector();
  // x* A x of a symmetric A.
  const auto square = [](const RealAndImaginary &x, const auto &multiply, DistributedVector &work)
  {
    multiply(work, x.real);
    double result = work * x.real;
    multiply(work, x.imaginary);
    return result + work * x.imaginary;
  };
  using Vector = DistributedVector;
  HarmonicPowers powers;
  for (unsigned int r = 0; r < operators.size(); ++r)
  {
    HarmonicPower power;
    if (LoadedBody<dim> *const loaded = equations.loaded_body())
    {
      power.viscosity =
          0.5 * omega * omega * loaded->square(LoadedPart::viscosity, r, solution.displacement);
      power.relaxation = 0.5 * omega * at_s.stiffness[r].imag() *
                         loaded->square(LoadedPart::relaxation, r, solution.displacement);
    }
    else
    {
      const double strain = square(
          u, [&](Vector &y, const Vector &x) { products.multiply_stiffness(r, y, x); },
          velocity_work);
      power.viscosity = 0.5 * omega * omega * problem.materials[r].shear.viscosity * strain;
      power.relaxation = 0.5 * omega * at_s.stiffness[r].imag() * strain - power.viscosity;
    }
    if (!at_s.compressibility.empty() && at_s.compressibility[r].imag() != 0.)
      power.relaxation -=
          0.5 * omega * at_s.compressibility[r].imag() *
          square(
              p, [&](Vector &y, const Vector &x) { products.multiply_pressure_mass(r, y, x); },
              pressure_work);
    if (operators[r].is_supported)
      power.supports =
          0.5 * omega * omega *
          square(
              u, [&](Vector &y, const Vector &x) { products.multiply_support_damping(r, y, x); },
              velocity_work);
    powers.regions.push_back(power);
  }
  HarmonicLoad forces, velocities, of_ports;
  forces.forces = load.forces;
  velocities.velocities = load.velocities;
  of_ports.ports = load.ports;
  powers.forces = power_of(forces, solution, load).real();
  powers.velocities = power_of(velocities, solution, load).real();
  powers.behind_ports = power_of(of_ports, solution, load).real();
  for (unsigned int port = 0; port < ports.size(); ++port)
  {
    const Complex behind = load.ports.empty() ? 0. : load.ports[port];
    powers.ports.push_back(ports.is_free_flow(port)
                               ? 0.
                               : 0.5 * ((solution.port_pressures[port] - behind) *
                                        std::conj(solution.port_flow_rates[port]))
                                           .real());
  }
  return powers;
}

template <int dim>
std::complex<double> HarmonicLedger<dim>::flow_rate(const unsigned int condition,
                                                    const HarmonicSolution &solution)
{
  constexpr double round_off = 1e-12;
  Complex of_rank = 0.;
  double size = 0.;
  for (const auto &[index, value] : entries_not_zero(equations.flow_of_velocities(condition)))
  {
    of_rank += value * solution.displacement[index];
    size += std::abs(value * solution.displacement[index]);
  }
  const Complex flow = equations.sum(of_rank);
  return std::abs(flow) > round_off * equations.sum(size).real() ? solution.s * flow : 0.;
}

template class HarmonicLedger<2>;
template class HarmonicLedger<3>;
} // namespace Continua
