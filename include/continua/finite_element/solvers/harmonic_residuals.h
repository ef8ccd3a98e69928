#ifndef continua_finite_element_solvers_harmonic_residuals_h
#define continua_finite_element_solvers_harmonic_residuals_h

#include <continua/continuum/harmonic_system.h>
#include <continua/finite_element/solvers/harmonic_equations.h>
#include <continua/finite_element/solvers/harmonic_ports.h>

#include <complex>
#include <vector>

namespace Continua
{
/// What a solution leaves of the equations of a motion exp(s t), with measures of it. Collective.
template <int dim>
class HarmonicResiduals
{
public:
  using Complex = std::complex<double>;

  /// Both must outlive it.
  HarmonicResiduals(HarmonicEquations<dim> &equations, const HarmonicPorts &ports)
      : equations(equations), ports(ports)
  {
  }

  /// Takes the left sides off the right ones, with ports where pressures are given; returns what is
  /// left: the larger of the forces over the largest force at a node, and of the dilatations over
  /// the largest displacement times the area of a node. Infinite of what is no number.
  double subtract_left_side(Complex s,
                            const std::vector<Complex> &displacement,
                            const std::vector<Complex> &pressure,
                            const std::vector<Complex> &port_pressures,
                            std::vector<Complex> &right);
  /// What the equations of the ports leave, as loads of ports that would mend it; returns the
  /// largest one, relative.
  double of_ports(const HarmonicLoad &load,
                  const HarmonicSolution &solution,
                  std::vector<Complex> &residuals) const;

private:
  HarmonicEquations<dim> &equations;
  const HarmonicPorts &ports;
};
} // namespace Continua

#endif
