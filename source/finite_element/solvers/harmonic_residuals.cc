#include <continua/finite_element/solvers/harmonic_residuals.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Continua
{
using namespace dealii;

namespace
{
/// Infinite of what is no number, and of a size without a scale.
double relative_size(const double size, const double scale)
{
  if (size == 0.)
    return 0.;
  const double relative = size / scale;
  return std::isfinite(relative) ? relative : std::numeric_limits<double>::infinity();
}
} // namespace

template <int dim>
double HarmonicResiduals<dim>::subtract_left_side(const Complex s,
                                                  const std::vector<Complex> &displacement,
                                                  const std::vector<Complex> &pressure,
                                                  const std::vector<Complex> &port_pressures,
                                                  std::vector<Complex> &right)
{
  const std::size_t n = equations.n_velocities();
  std::vector<Complex> forces, dilatations;
  equations.apply(equations.coefficients(s), displacement, pressure, forces, dilatations);
  for (std::size_t port = 0; port < port_pressures.size(); ++port)
    equations.add_port(port, port_pressures[port], forces);
  // Before they cancel, the rows of what is held among them. Of a liquid without compression the
  // dilatations of a node cancel in its row.
  const double scale = std::max(equations.size_of(forces), equations.size_of(right, 0, n));
  const double scale_of_dilatations =
      std::max({equations.area_of_node() * equations.size_of(displacement),
                equations.size_of(dilatations), equations.size_of(right, n, right.size())});
  equations.restrict_rows(forces, dilatations);
  for (std::size_t i = 0; i < right.size(); ++i)
    right[i] -= i < n ? forces[i] : dilatations[i - n];
  return std::max(relative_size(equations.size_of(right, 0, n), scale),
                  relative_size(equations.size_of(right, n, right.size()), scale_of_dilatations));
}

template <int dim>
double HarmonicResiduals<dim>::of_ports(const HarmonicLoad &load,
                                        const HarmonicSolution &solution,
                                        std::vector<Complex> &residuals) const
{
  const unsigned int n_ports = ports.size();
  const FullMatrix<Complex> impedance = ports.impedances(solution.s);
  std::vector<Complex> flows;
  std::vector<double> sizes; // of the flows, before they cancel
  for (unsigned int port = 0; port < n_ports; ++port)
  {
    flows.push_back(equations.flow_of_port(port, solution.displacement, solution.s));
    sizes.push_back(equations.size_of_flow(port, solution.displacement, solution.s));
  }
  residuals.assign(n_ports, 0.);
  double largest = 0.;
  for (unsigned int port = 0; port < n_ports; ++port)
  {
    const Complex given = load.ports.empty() ? 0. : load.ports[port];
    double scale = std::abs(given);
    if (ports.is_free_flow(port))
    {
      residuals[port] = given + flows[port];
      scale += sizes[port];
    }
    else
    {
      residuals[port] = given - solution.port_pressures[port];
      scale += std::abs(solution.port_pressures[port]);
      for (unsigned int other = 0; other < n_ports; ++other)
      {
        residuals[port] += impedance(port, other) * flows[other];
        scale += std::abs(impedance(port, other)) * sizes[other];
      }
    }
    largest = std::max(largest, relative_size(std::abs(residuals[port]), scale));
  }
  return largest;
}

template class HarmonicResiduals<2>;
template class HarmonicResiduals<3>;
} // namespace Continua
