#ifndef continua_continuum_outlet_model_h
#define continua_continuum_outlet_model_h

#include <continua/continuum/end_model.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * The zero-dimensional model behind the ports of one outlet: flow rates Q in [m^3/s], pressures p
 * out [Pa]. In a step it is linear, p = predicted + Z Q at the balanced level, with Z = direct +
 * sum_k residue_k (velocity coefficient of x_k) and first-order responses dx_k/dt = Q - rate_k x_k
 * [m^3], one number a port. On the way to a steady state a term stands as in a steady flow, x_k =
 * Q/rate_k, unless its x_k at t = 0 is given: a charge that is given stays.
 */
class OutletModel : public EndModel
{
public:
  /// At the state of t = 0. `outlet` must outlive it.
  explicit OutletModel(const Outlet &outlet);
  /// It is copied, never moved: deal.II's vectors may throw when they move.
  OutletModel(const OutletModel &) = default;

  unsigned int n_ports() const override { return outlet.impedance.n_ports(); }
  /// Linearises for a step from the flow rates at its start. Returns whether Z has changed.
  bool linearise(const Step &step, const double *flow_rates_old) override;
  /// Linearises for a steady flow, with Z(0), or with the charge that is given. Throws RunError if
  /// no steady flow passes.
  bool linearise_steady(double time) override;
  const dealii::Vector<double> &predicted_pressures() const override { return predicted; }
  /// Z [Pa s/m^3].
  dealii::FullMatrix<double> impedance() const override;

  /// Moves on to the end of the step, by the flow rates at its balanced level.
  void advance(const Step &step, const double *flow_rates) override;
  /// The run begins with these flow rates, see Outlet::counts_from_start.
  void start_from(const double *flow_rates) override;
  /// Takes the state of a steady flow.
  void set_steady(const double *flow_rates) override;

  /// Of the last step, at its balanced level: the power that is stored; 0 if the terms are no
  /// stores [W].
  double stored_power() const override;
  /// Stored at the present time [J].
  double energy() const override;
  /// The ports' pressures at the present time, of the flow rates there [Pa].
  std::vector<double> present_pressures(double time, const double *flow_rates) const override;
  /// Whether the pressure behind it jumps between the two times [s].
  bool jumps(double begin, double end) const override;

  /// Hands over all that a step changes; `number`: of the outlet.
  void visit(StateVisitor &visitor, unsigned int number) override;

private:
  /// One first-order response x_k, by port [m^3].
  struct Response
  {
    dealii::Vector<double> present, older, at_level;
    dealii::Vector<double> rate; ///< dx_k/dt as the step has it [m^3/s]
  };
  const Outlet &outlet;
  std::vector<Response> responses; ///< by term of the impedance
  /// Of x_k by Q in the step [s], and the factor of the direct part [1]; empty before the first
  /// one.
  std::vector<double> coefficients;
  dealii::Vector<double> start_flow_rates; ///< of an outlet that counts from there [m^3/s]
  dealii::Vector<double> predicted;

  /// Then there is one port.
  bool has_given_charge() const { return !outlet.initial_states.empty(); }
  bool take_coefficients(const std::vector<double> &new_coefficients);
  double change_of_flow(const double *flow_rates, const unsigned int port) const
  {
    return flow_rates[port] - start_flow_rates[port];
  }
  std::vector<double> new_coefficients; ///< work space
};
} // namespace Continua

#endif
