#ifndef continua_network_end_wave_h
#define continua_network_end_wave_h

#include <continua/network/vessel.h>

namespace Continua
{
/**
 * The wave that runs from an end of a vessel into it: it connects the state inside the end, which
 * the liquid brings, with the state on the end. Along it dU/dA = ((alpha - 1) U -+ s)/A, with the
 * relative speed s of the waves. For alpha = 1 it is Riemann's invariant. The integral from the
 * area inside is that of Simpson: its error is of fifth order in the difference of the areas.
 */
class EndWave
{
public:
  EndWave(Vessel &vessel, Vessel::End end);

  /// 1 if the node is at the end of the vessel, -1 at its start: times the flow rate in the vessel
  /// this is the flow rate into the node.
  double direction() const { return sign; }
  Vessel &of() const { return vessel; }
  Vessel::End at() const { return end; }
  double density() const { return vessel.flow_law().density; }

  /// Takes the state inside the end, after Vessel::reconstruct().
  void begin();
  const Vessel::State &inside() const { return trace; }

  /// What the end has with the area A, with derivatives to A.
  struct Values
  {
    double pressure, stiffness;      ///< [Pa], [Pa/m^2]
    double velocity, velocity_slope; ///< along the vessel [m/s], [1/(m s)]
    double inflow, inflow_slope;     ///< flow rate into the node [m^3/s], [m/s]
    double head, head_slope;         ///< p + rho alpha U^2/2 [Pa], [Pa/m^2]
  };
  Values at_area(double area) const;
  /// Sets the end of the vessel to this area.
  void take(double area);
  /// integral of c/A dA between two areas [m/s].
  double speed_integral(double from, double to) const;

private:
  Vessel &vessel;
  Vessel::End end;
  double sign;
  Vessel::State trace;
  double trace_rate = 0.; ///< dU/dA there

  /// dU/dA [1/(m s)] along the wave with the velocity of the trace.
  double rate(double area, double stiffness) const;
};
} // namespace Continua

#endif
