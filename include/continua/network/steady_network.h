#ifndef continua_network_steady_network_h
#define continua_network_steady_network_h

#include <continua/network/network.h>
#include <continua/network/solve_rows.h>

#include <functional>
#include <vector>

namespace Continua
{
/**
 * The steady flow in a network: one flow rate in each vessel and each element between two nodes,
 * with the losses of the friction (SteadyProfile) and of the resistances; into compliances nothing
 * flows, and a windkessel is the sum of its resistances. What depends on time is as at a time, or
 * has its mean over a period. By Newton's method for the pressures of the nodes (where vessels
 * meet: p + rho alpha U^2/2, which they have in common) and the flow rates.
 */
class SteadyNetwork
{
public:
  /// `nodes`: into which flow rates are given. The network must outlive it.
  SteadyNetwork(Network &network, const std::vector<unsigned int> &nodes);

  /// Whether there is a steady flow for any flow rates into the nodes: what is connected with them
  /// has somewhere a given pressure, a resistance, a windkessel or an absorbing end, and the
  /// network has no chamber, whose beats make a mean of their own.
  bool exists() const;

  /// When loads have their value: at a time [s], or their mean over `period` [s] if that is
  /// positive.
  struct When
  {
    double time = 0., period = 0.;
  };
  /// With these flow rates [m^3/s] into the nodes. Throws StepFailure without a solution.
  void solve(const std::vector<double> &flow_rates, const When &when);
  /// Of the last solve, by number among the nodes: the pressure [Pa], and its change by the flow
  /// rate into another one [Pa s/m^3].
  double pressure(const unsigned int i) const { return unknowns[nodes[i]]; }
  double slope(const unsigned int i, const unsigned int by) const { return slopes[by][nodes[i]]; }
  /// Lets the network have the state of the last solve.
  void start();

private:
  Network &network;
  std::vector<unsigned int> nodes;
  std::vector<char> is_junction; ///< by node
  /// Pressures of the nodes [Pa], flow rates of the vessels, then of the elements [m^3/s].
  std::vector<double> unknowns;
  std::vector<std::vector<double>> slopes; ///< of the unknowns, by the flow rate into each node
  std::vector<double> defects, old, change;
  Rows matrix, rows;

  std::size_t n_nodes() const { return is_junction.size(); }
  std::size_t place_of_vessel(const unsigned int edge) const { return n_nodes() + edge; }
  std::size_t place_of_element(const unsigned int element) const
  {
    return n_nodes() + network.edges.size() + element;
  }
  static double value(const std::function<double(double)> &load, const When &when);
  /// The pressure at the start of a vessel whose node has this pressure, or head.
  double start_pressure(unsigned int edge, double at_node, double flow) const;
  /// What the node at its end then has.
  double at_end(unsigned int edge, double at_start, double flow) const;
  double absorbing_defect(const Terminal &terminal, double pressure, double outflow) const;
  void set_equations(const std::vector<double> &flow_rates, const When &when);
  void set_vessel(unsigned int edge);
  void set_terminal(const Network::Loose &loose, const When &when);
  void set_elements(const When &when);
  bool solve_for(const std::vector<double> &right);
};
} // namespace Continua

#endif
