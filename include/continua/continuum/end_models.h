#ifndef continua_continuum_end_models_h
#define continua_continuum_end_models_h

#include <continua/continuum/end_model.h>

#include <memory>
#include <vector>

namespace Continua
{
/// What stands behind all outlets, see EndModel. Flow rates out [m^3/s] and pressures [Pa] are by
/// port: the ports of the first outlet, then those of the next.
class EndModels
{
public:
  /// Numbers the ports.
  void reinit(const std::vector<Outlet> &outlets);
  /// The states of t = 0. The outlets must outlive it.
  void initialise(const std::vector<Outlet> &outlets);

  unsigned int first_port(const unsigned int outlet) const { return first_ports[outlet]; }

  /// Linearise for a step from the flow rates at its start, or for a steady flow; whether Z has
  /// changed.
  bool linearise(const Step &step, const double *flow_rates_old);
  bool linearise_steady(double time);
  void linearise_about(const std::vector<double> &flow_rates);
  /// Whether the flow rates that were found have changed the linear relation.
  bool correct(const std::vector<double> &flow_rates);
  /// Sets p_plus and Z of p = p_plus + Z Q.
  void set_predicted(dealii::Vector<double> &pressures) const;
  void set_impedances(dealii::FullMatrix<double> &impedances) const;
  /// p_plus + Z Q.
  void set_pressures(const std::vector<double> &flow_rates, std::vector<double> &pressures) const;

  void advance(const Step &step, const std::vector<double> &flow_rates);
  void start_from(const std::vector<double> &flow_rates);
  void set_steady(const std::vector<double> &flow_rates);

  double stored_power(const unsigned int outlet) const { return models[outlet]->stored_power(); }
  /// Of all of them [J].
  double energy() const;
  std::vector<double> present_pressures(double time, const std::vector<double> &flow_rates) const;
  bool jumps(double begin, double end) const;
  /// The first network, or null.
  const Network *network();
  void visit(StateVisitor &visitor);

private:
  std::vector<unsigned int> first_ports;         ///< by outlet
  std::vector<std::unique_ptr<EndModel>> models; ///< by outlet
};
} // namespace Continua

#endif
