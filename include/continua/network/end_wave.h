#ifndef continua_network_end_wave_h
#define continua_network_end_wave_h

#include <continua/network/vessel.h>

#include <utility>

namespace Continua
{
/**
 * The wave that runs from an end of a vessel into it: it connects the state inside the end, which
 * the liquid brings, with the state on the end. Along it dU/dA = ((alpha - 1) U -+ s)/A, with the
 * relative speed s of the waves. For alpha = 1 it is Riemann's invariant. From the area inside it
 * is integrated by Kutta's method of third order, whose error in the difference of the areas is of
 * fourth order, and for alpha = 1, where it is the rule of Simpson, of fifth order. A shock between
 * the two states is connected in the same way, with an error of third order in its jump.
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
  /// The velocity [m/s] at an area, and its derivative [1/(m s)], of a wave that leaves the vessel
  /// through this end into liquid at rest with the area `start_area` [m^2]: nothing comes in.
  std::pair<double, double> leaving(double start_area, double area) const;

private:
  Vessel &vessel;
  Vessel::End end;
  double sign;
  Vessel::State trace;
  double trace_rate = 0.; ///< dU/dA there

  /// dU/dA [1/(m s)] along a wave that runs towards the end of the vessel (direction 1) or its
  /// start
  /// (-1).
  double rate(double direction, double area, double stiffness, double velocity) const;
};
} // namespace Continua

#endif
