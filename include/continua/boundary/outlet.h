#ifndef continua_boundary_outlet_h
#define continua_boundary_outlet_h

#include <continua/signal/waveform.h>
#include <continua/theory/impedance.h>

#include <complex>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
struct NetworkParameters;

/**
 * An end of the body behind which something answers to what flows out: a resistance, a windkessel,
 * the rest of a long tube, or a network of vessels, which may stand at several ends. Each of its
 * ports is one boundary condition of the problem (the liquid's section, or the end of the wall), on
 * whose faces the normal traction is -p n with one pressure p for all of the port, and whose flow
 * rate is Q = int U . n, out of the body.
 */
struct Outlet
{
  /// How a port holds the section.
  enum class Coupling
  {
    pressure, ///< the traction is uniform; the velocity's distribution is free
    flow      ///< the velocity has a prescribed distribution, of which only the flow rate is free
  };
  std::string name; ///< of the boundary condition of its first port
  /// The ports' numbers among the problem's boundary conditions.
  std::vector<unsigned int> conditions;
  /// Of the modelled part of the section: a quarter of a tube has a quarter of its flow.
  Impedance impedance;
  /// The same at s [1/s], where no sum of first-order responses has to stand for it: of an
  /// absorbing end of a tube in the frequency domain. Empty: `impedance` is exact.
  std::function<dealii::FullMatrix<std::complex<double>>(std::complex<double> s)> exact_impedance;
  Waveform pressure_behind; ///< [Pa], a function of time alone: added at the first port
  Coupling coupling = Coupling::pressure;
  /// x_k of the first port at t = 0 [m^3], by term; empty is zero.
  std::vector<double> initial_states;
  /// A network behind the ports, each of which stands at one of its nodes (nodes_at_body, in the
  /// order of the ports). Null: what is behind them is the impedance.
  std::shared_ptr<const NetworkParameters> network;
  std::vector<double> fractions; ///< by port of a network: of the section that the mesh has [1]
  /// Whether it answers to what the flow rates differ by from those at the start of the run. A
  /// search for a steady state before that has the pressure behind it at the first port, whatever
  /// flows.
  bool counts_from_start = false;

  /// Z(s) [Pa s/m^3], as exactly as it is known. Throws RunError where there is none.
  dealii::FullMatrix<std::complex<double>> impedance_at(const std::complex<double> s) const
  {
    return exact_impedance ? exact_impedance(s) : impedance.value(s);
  }
};
} // namespace Continua

#endif
