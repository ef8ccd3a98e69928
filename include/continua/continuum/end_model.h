#ifndef continua_continuum_end_model_h
#define continua_continuum_end_model_h

#include <continua/boundary/outlet.h>
#include <continua/continuum/state_visitor.h>
#include <continua/time_integration/step.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <vector>

namespace Continua
{
class Network;

/**
 * What stands behind the ports of one outlet: flow rates Q in [m^3/s], pressures p out [Pa]. In a
 * step it is linear at the balanced level, p = predicted + Z Q; what is not linear is linearised
 * about the flow rates that were found, until they stay (correct()).
 */
class EndModel
{
public:
  EndModel() = default;
  virtual ~EndModel() = default;
  EndModel &operator=(const EndModel &) = delete;

  virtual unsigned int n_ports() const = 0;
  /// Linearises for a step from the flow rates at its start. Returns whether Z has changed.
  virtual bool linearise(const Step &step, const double *flow_rates_old) = 0;
  /// Linearises for a steady flow. Throws RunError if no steady flow passes.
  virtual bool linearise_steady(double time) = 0;
  /// Takes the flow rates that were found in the step at its balanced level. False if they belong
  /// to the pressures of the linear relation; else that is now the one about these flow rates.
  /// Throws StepFailure.
  virtual bool correct(const double * /*flow_rates*/) { return false; }
  /// Lets the linear relation be the one about the flow rates of an iterate. Throws StepFailure.
  virtual void linearise_about(const double * /*flow_rates*/) {}
  virtual const dealii::Vector<double> &predicted_pressures() const = 0;
  /// Z [Pa s/m^3].
  virtual dealii::FullMatrix<double> impedance() const = 0;

  /// Moves on to the end of the step, by the flow rates at its balanced level.
  virtual void advance(const Step &step, const double *flow_rates) = 0;
  /// The run begins with these flow rates, see Outlet::counts_from_start.
  virtual void start_from(const double * /*flow_rates*/) {}
  /// Takes the state of a steady flow.
  virtual void set_steady(const double *flow_rates) = 0;

  /// Of the last step, at its balanced level: the power that is stored, as far as it is known [W].
  virtual double stored_power() const { return 0.; }
  /// Stored at the present time, as far as it is known [J].
  virtual double energy() const { return 0.; }
  /// The ports' pressures at the present time, of the flow rates there [Pa].
  virtual std::vector<double> present_pressures(double time, const double *flow_rates) const = 0;
  /// Whether the pressure behind it jumps between the two times [s].
  virtual bool jumps(double begin, double end) const = 0;
  /// The network behind the ports in its present state, or null.
  virtual const Network *network() { return nullptr; }

  /// Hands over all that a step changes; `number`: of the outlet.
  virtual void visit(StateVisitor &visitor, unsigned int number) = 0;

protected:
  EndModel(const EndModel &) = default;
};

/// The model of an outlet, which must outlive it.
std::unique_ptr<EndModel> make_end_model(const Outlet &outlet);
} // namespace Continua

#endif
