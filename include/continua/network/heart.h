#ifndef continua_network_heart_h
#define continua_network_heart_h

#include <continua/network/state_numbers.h>

#include <functional>

namespace Continua
{
/**
 * A chamber of the heart with two valves, without a length (H. Suga, K. Sagawa, A. A. Shoukas,
 * Circ. Res. 32 (1973) 314): the pressure in it is elastance(t) (volume - unloaded_volume). It
 * fills from a constant pressure through a valve with a resistance, and empties through another one
 * into a vessel. A valve lets nothing flow back. Volumes are those of the trapezoidal rule.
 */
class Heart
{
public:
  struct Law
  {
    std::function<double(double)> elastance; ///< of time [s]: [Pa/m^3], positive
    double unloaded_volume = 0.;             ///< [m^3]
    double initial_volume = 0.;              ///< [m^3]
    double valve_resistance = 0.;            ///< of the valve to the vessel [Pa s/m^3]
    double filling_pressure = 0.;            ///< [Pa]
    double filling_resistance = 0.;          ///< of the other valve, positive [Pa s/m^3]
  };
  explicit Heart(const Law &law);

  double volume() const { return now; }    ///< [m^3]
  double work() const { return done; }     ///< that it has done since the start [J]
  double pressure(const double time) const ///< of the present volume [Pa]
  {
    return law.elastance(time) * (now - law.unloaded_volume);
  }
  /// The pressure in the chamber [Pa] in a stage at the begin (or the end) of a step, if it gives
  /// this flow rate [m^3/s] at the end of the step; and its derivative [Pa s/m^3].
  struct Pressure
  {
    double value, slope;
  };
  Pressure pressure(bool at_end_of_step, double time, double step, double outflow) const;
  /// Takes the flow rate that was found in a stage.
  void take(bool at_end_of_step, double time, double step, double outflow);
  /// After the second stage of a step from `time` over `step` [s].
  void end_step(double time, double step);
  /// Whether the valve to the vessel is open, where the vessel has this pressure [Pa] without a
  /// flow.
  bool is_open(bool at_end_of_step, double time, double step, double outside) const
  {
    return pressure(at_end_of_step, time, step, 0.).value > outside;
  }
  double valve_resistance() const { return law.valve_resistance; }
  /// Hands over what a step changes.
  void visit(StateNumbers &numbers)
  {
    for (double *const member : {&now, &next, &outflow_at_begin, &filling_at_begin})
      numbers.value(*member);
  }
  /// The same for what only counts since the start.
  void visit_sums(StateNumbers &numbers) { numbers.value(done); }

private:
  Law law;
  double now, next; ///< volume at the begin and the end of the step [m^3]
  double outflow_at_begin = 0., filling_at_begin = 0.; ///< [m^3/s]
  double done = 0.;                                    ///< [J]

  double filling(double pressure) const;
  double volume_at_end(double time, double step, double outflow, double &slope) const;
};
} // namespace Continua

#endif
