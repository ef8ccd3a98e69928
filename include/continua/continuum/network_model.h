#ifndef continua_continuum_network_model_h
#define continua_continuum_network_model_h

#include <continua/continuum/end_model.h>
#include <continua/continuum/network_end_state.h>
#include <continua/continuum/steady_network_end.h>
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
 * The flow rate of the balanced level enters the network all through an interval of time about that
 * level, and the pressure is the mean over this interval of that at the node. So the volume and the
 * work p Q that leave the body are those that enter the network, whatever the scheme, and the joint
 * makes no energy. With backward Euler and backward differencing, whose balanced level is the end
 * of the step, the network is half a step ahead of the body. A step of another size moves the
 * network by as much more or less as half of that size has changed; where it is ahead by more than
 * that, it waits: each step then takes it half a step further until it has its place. The balanced
 * level is not in the middle of such an interval, and what flow rate and pressure differ by between
 * the two follows from their rates in the last step of an even size: else each change of the size
 * would be a jump of the flow rate, which rings in vessels that are nearly rigid.
 *
 * On the way to a steady state of the body it has the pressures of its own steady flow, and the run
 * starts from that (SteadyNetworkEnd); else it waits at rest under its initial pressure.
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
  void start_from(const double *flow_rates) override;
  void set_steady(const double *flow_rates) override;
  double stored_power() const override;
  std::vector<double> present_pressures(double time, const double *flow_rates) const override;
  bool jumps(double /*begin*/, double /*end*/) const override { return false; }
  const Network *network() override;
  void visit(StateVisitor &visitor, unsigned int number) override;

private:
  const Outlet &outlet;
  /// Into the nodes, by port [m^3/s]; the network asks for them.
  std::shared_ptr<std::vector<double>> inflows;
  Network vessels;
  std::vector<unsigned int> nodes; ///< by port
  /// By port: A dp/dA [Pa], and the flow rate A c [m^3/s] of a liquid as fast as the wave.
  std::vector<double> stiffness, flow_scale;
  /// Whether elements alone stand at some port. A valve there has a kink in its pressure, which
  /// changes of the trials do not follow, but differences do.
  bool has_elements_alone = false;
  NetworkEndState present, older;
  SteadyNetworkEnd steady;

  // Of the step.
  Step step;
  bool is_linearised = false;
  unsigned int n_steps = 1;              ///< of the network in it
  double begin_time = 0., end_time = 0.; ///< of the network's interval [s]
  double offset = 0.; ///< of the middle of that interval from the balanced level [s]
  unsigned int n_corrections = 0;
  std::vector<double> steady_flow_rates; ///< of the last step on the way to a steady state
  std::vector<double> trial_flow_rates;  ///< of the last trial; empty: none
  std::vector<double> trial_pressures;
  dealii::FullMatrix<double> z;
  dealii::Vector<double> predicted;

  /// Sets the interval of the network for the step.
  void place_interval();
  /// The pressures at the balanced level with these flow rates; the network is at the end of its
  /// interval then. Throws StepFailure.
  void make_trial(const double *flow_rates);
  /// Z by differences about these flow rates, and the trial with them. A copy: trials change what
  /// the last one had.
  void find_impedance(std::vector<double> flow_rates);
  /// Takes flow rates and pressures of the balanced level, and their slopes, into `now`.
  void
  take_levels(const double *flow_rates, const NetworkEndState &before, NetworkEndState &now) const;
  void take_update(const std::vector<double> &flow_rates_before,
                   const std::vector<double> &pressures_before);
  /// Z after another trial: by its change, or where that says too little by differences.
  void update_impedance(const std::vector<double> &flow_rates_before,
                        const std::vector<double> &pressures_before,
                        bool is_slow);
  /// The linear relation passes through the last trial.
  void set_predicted();
  void restore();
  /// Whether it stays at rest, while the body is on its way to a steady state.
  bool waits() const { return step.finds_steady_state && !steady.applies(step); }
  [[noreturn]] void refuse_steady() const;
  /// Takes the state in which the vessels are.
  void take_state();
};
} // namespace Continua

#endif
