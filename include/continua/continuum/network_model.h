#ifndef continua_continuum_network_model_h
#define continua_continuum_network_model_h

#include <continua/continuum/end_model.h>
#include <continua/network/network.h>

#include <memory>
#include <vector>

namespace Continua
{
/**
 * A network of vessels behind the ports of an outlet, each at one loose end of it. Within a step of
 * the body it goes on in as many equal steps of its own as its waves need, always from its state at
 * the start of the step.
 *
 * The flow rate of the balanced level enters the network all through the step, and the pressure is
 * the mean over the step of that at the node. So the volume and the work p Q that leave the body
 * are those that enter the network, whatever the scheme, and the joint makes no energy. With
 * backward Euler and backward differencing, whose balanced level is the end of the step, the
 * network is half a step ahead of its own clock, and its mean pressure as much behind its state:
 * together both are in time. Terminals and chambers that depend on time have the clock of the body.
 *
 * p(Q) is linear up to the waves of finite height. Z is found by differences where the size of the
 * step is a new one, and follows from step to step by C. G. Broyden's update (Math. Comp. 19 (1965)
 * 577): with one port the secant.
 */
class NetworkModel : public EndModel
{
public:
  /// At the state of t = 0. `outlet` must outlive it.
  explicit NetworkModel(const Outlet &outlet);

  unsigned int n_ports() const override { return nodes.size(); }
  bool linearise(const Step &step, const double *flow_rates_old) override;
  bool linearise_steady(double time) override;
  bool correct(const double *flow_rates) override;
  void linearise_about(const double *flow_rates) override;
  const dealii::Vector<double> &predicted_pressures() const override { return predicted; }
  dealii::FullMatrix<double> impedance() const override { return z; }
  void advance(const Step &step, const double *flow_rates) override;
  void set_steady(const double *flow_rates) override;
  double stored_power() const override;
  std::vector<double> present_pressures(double time, const double *flow_rates) const override;
  bool jumps(double /*begin*/, double /*end*/) const override { return false; }
  const Network *network() override;
  void visit(StateVisitor &visitor, unsigned int number) override;

private:
  /// The state at the present time.
  struct State
  {
    std::vector<double> network;    ///< StateNumbers
    std::vector<double> pressures;  ///< of the nodes [Pa]
    std::vector<double> z;          ///< by rows, of the last step [Pa s/m^3]
    std::vector<double> flow_rates; ///< at the balanced level of the last step [m^3/s]
    double size = 0.;               ///< of the last step [s]; 0: none
    double energy = 0.;             ///< of the network [J]
  };
  const Outlet &outlet;
  /// Into the nodes, by port [m^3/s]; the network asks for them.
  std::shared_ptr<std::vector<double>> inflows;
  Network vessels;
  std::vector<unsigned int> nodes; ///< by port
  /// By port: A dp/dA [Pa], and the flow rate A c [m^3/s] of a liquid as fast as the wave.
  std::vector<double> stiffness, flow_scale;
  State present, older;

  // Of the step.
  Step step;
  bool is_linearised = false;
  unsigned int n_steps = 1; ///< of the network in it
  unsigned int n_corrections = 0;
  std::vector<double> trial_flow_rates; ///< of the last trial; empty: none
  std::vector<double> trial_pressures;
  dealii::FullMatrix<double> z;
  dealii::Vector<double> predicted;

  /// The pressures at the balanced level with these flow rates; the network is at the end of the
  /// step then. Throws StepFailure.
  void make_trial(const double *flow_rates);
  /// Z by differences about these flow rates, and the trial with them.
  void find_impedance(const std::vector<double> &flow_rates);
  void take_update(const std::vector<double> &flow_rates_before,
                   const std::vector<double> &pressures_before);
  /// The linear relation passes through the last trial.
  void set_predicted();
  void restore();
  static void visit_state(StateVisitor &visitor, unsigned int number, State &now, State &before);
};
} // namespace Continua

#endif
