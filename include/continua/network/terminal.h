#ifndef continua_network_terminal_h
#define continua_network_terminal_h

#include <continua/network/end_wave.h>
#include <continua/network/heart.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>

namespace Continua
{
/// What stands at a loose end of a vessel.
struct TerminalLaw
{
  enum class Type
  {
    flow_rate, ///< Q(t) into the vessel
    pressure,  ///< p(t)
    resistance,
    windkessel, ///< a resistance before a compliance beside a resistance
    heart,      ///< a chamber with valves, out of which liquid flows into the vessel
    absorbing,  ///< the vessel goes on without limit
    closed
  };
  Type type = Type::closed;
  std::function<double(double)> value; ///< of time [s]: flow rate [m^3/s] or pressure [Pa]
  double resistance = 0.;              ///< or the proximal one [Pa s/m^3]
  double distal_resistance = 0.;       ///< [Pa s/m^3]
  double compliance = 0.;              ///< [m^3/Pa]
  double pressure_behind = 0.;         ///< [Pa]
  /// Of the compliance at the start, or of the state at rest of an absorbing end [Pa]
  double initial_pressure = 0.;
  Heart::Law heart;
};

/**
 * A loose end of a vessel, with the law that it follows. In each stage of a step the state on the
 * end satisfies the law and the wave of the vessel together (EndWave), by Newton's method.
 *
 * Behind an absorbing end of a wall that relaxes the liquid is taken to have half the pressure of
 * the memory: of a wave of the relative stiffness 1 + x the impedance is in proportion to sqrt(1 +
 * x), and 1 + x/2 over it is 1 + x^2/8 - ..., so that little returns.
 *
 * The pressure of a windkessel's compliance is the exact one for a flow rate that is linear in the
 * step, with the flow rate at the end of the step unknown: second order, and stable for any step.
 */
class Terminal
{
public:
  Terminal(Vessel &vessel, Vessel::End end, const TerminalLaw &law);

  /// The stage at the begin (or the end) of a step from `time` to `time + step` [s]. Returns the
  /// flow rate into the vessel [m^3/s]. Throws std::domain_error where the law and the wave have no
  /// common state.
  double solve(bool at_end_of_step, double time, double step);
  /// The law for the implicit stage of a memory, linear: `of_flow` times the flow rate out of the
  /// network, and `of_pressure` times the pressure, are together `right`; of the pressure of the
  /// memory only `memory_share` counts.
  struct LinearLaw
  {
    double of_flow, of_pressure, right, memory_share;
  };
  LinearLaw linear_law(bool at_end_of_step, double time, double step) const;
  const TerminalLaw &end_law() const { return law; }
  /// Takes the state of a steady flow, with a pressure [Pa] and a flow rate out of the network
  /// [m^3/s].
  void start_steady(double pressure, double outflow);
  /// The end of the vessel.
  const EndWave &end() const { return wave; }
  /// After the second stage of a step from `time` over `step` [s].
  void end_step(double time, double step);
  const Heart &chamber() const { return heart; } ///< of a heart
  double energy() const;                         ///< of a compliance [J]
  /// On the end, in the last stage [Pa].
  double pressure() const { return pressure_of_stage; }
  /// Hands over what a step changes.
  void visit(StateNumbers &numbers);
  /// The same for what only counts since the start.
  void visit_sums(StateNumbers &numbers) { heart.visit_sums(numbers); }

private:
  EndWave wave;
  TerminalLaw law;
  Heart heart;
  bool valve_is_open = false;   ///< of the heart, in the last stage
  double compliance_pressure;   ///< at the begin of the step [Pa]
  double next_pressure = 0.;    ///< at its end
  double outflow_at_begin = 0.; ///< out of the network [m^3/s]
  double pressure_of_stage;     ///< [Pa]
  /// Of an absorbing end in the last stage, with half the pressure of the memory [Pa], [m^3/s].
  double last_pressure, last_outflow = 0.;

  /// What stands behind the end: pressure = source + resistance outflow, and of a windkessel the
  /// pressure of its compliance is source + of_outflow outflow.
  struct Behind
  {
    double source, resistance, of_outflow;
  };
  Behind behind(bool at_end_of_step, double step) const;
  /// Sets valve_is_open, too.
  double area_with_heart(bool at_end_of_step, double time, double step);
  double area_with(double time, double source, double resistance) const;
};
} // namespace Continua

#endif
