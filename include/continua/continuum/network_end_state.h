#ifndef continua_continuum_network_end_state_h
#define continua_continuum_network_end_state_h

#include <continua/continuum/state_visitor.h>

#include <vector>

namespace Continua
{
/// The state of a network at ends of a body, by port where it is of a node.
struct NetworkEndState
{
  std::vector<double> network;         ///< StateNumbers
  std::vector<double> pressures;       ///< of the nodes [Pa]
  std::vector<double> z;               ///< by rows, of the last step [Pa s/m^3]
  std::vector<double> flow_rates;      ///< at the balanced level of the last step [m^3/s]
  std::vector<double> level_pressures; ///< there [Pa]
  /// By time, of the last step whose interval lies evenly about its level [m^3/s^2], [Pa/s].
  std::vector<double> flow_slopes, pressure_slopes;
  double interval = 0.; ///< of the network in the last step [s]; 0: none
  double size = 0.;     ///< of the last step [s]; 0: none
  double level = 0.;    ///< balanced in it [s]
  double energy = 0.;   ///< of the network [J]

  /// Hands it over as the present level, with the older one; `number`: of the outlet.
  void visit(StateVisitor &visitor, unsigned int number, NetworkEndState &before);
};
} // namespace Continua

#endif
