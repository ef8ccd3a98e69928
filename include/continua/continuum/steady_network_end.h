#ifndef continua_continuum_steady_network_end_h
#define continua_continuum_steady_network_end_h

#include <continua/boundary/outlet.h>
#include <continua/network/steady_network.h>
#include <continua/time_integration/step.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Continua
{
/**
 * What a network is for a body on its way to a steady state: its own steady flow with the flow
 * rates of the body. Where it has none (SteadyNetwork::exists()), where the file gives a state at
 * rest (but for a start from the mean of the loads), and for the unloaded shape it waits at rest.
 */
class SteadyNetworkEnd
{
public:
  /// Both must outlive it. `nodes`: of the network, by port.
  SteadyNetworkEnd(const Outlet &outlet, Network &network, const std::vector<unsigned int> &nodes);

  bool applies(const Step &step) const;
  /// The pressures [Pa] with these flow rates [m^3/s], by port, and their derivatives [Pa s/m^3].
  /// While the loads come, those of the network are what its pressures are without a flow. Throws
  /// StepFailure.
  void solve(const Step &step,
             const double *flow_rates,
             std::vector<double> &pressures,
             dealii::FullMatrix<double> &impedance);
  /// Lets the network have the state of the last solve.
  void start() { flow.start(); }

private:
  const Outlet &outlet;
  SteadyNetwork flow;
  bool exists;

  void find(const std::vector<double> &flow_rates, const Step &step);
};
} // namespace Continua

#endif
