#ifndef continua_theory_reflection_h
#define continua_theory_reflection_h

#include <continua/theory/complex_bessel.h>

#include <string>
#include <vector>

namespace Continua
{
/// Characteristic impedance rho c / A (6.19) [Pa s/m^3] of an inviscid wave; `speed` [m/s] may be
/// complex. With viscosity see Womersley::characteristic_impedance.
Complex characteristic_impedance(double density, Complex speed, double area);

/**
 * Ratio of the pressures of reflected and incoming wave (6.21) [1] at the end of a tube of the
 * characteristic impedance `impedance`, where the impedance `load` [Pa s/m^3] follows: (Z_load - Z)
 * / (Z_load + Z). A closed end (infinite load) has 1, an open one (no load) -1, a matched one 0.
 */
Complex reflection_coefficient(Complex impedance, Complex load);
/// The same for a junction with any number of tubes (6.20): pressure is one, flow is conserved.
Complex junction_reflection(Complex impedance, const std::vector<Complex> &branches);
/// Pressure of each wave that goes on over that of the incoming one: 1 + reflection [1].
Complex junction_transmission(Complex impedance, const std::vector<Complex> &branches);

/**
 * A harmonic wave in a uniform tube, 0 <= z <= L, between two ends. The series of all its
 * reflections is summed:
 *
 *     p = P (exp(-ikz) + G_L exp(-ik(2L - z))) / (1 - G_0 G_L exp(-2ikL))
 *
 * This takes the place of (6.25, 6.26), which grow with every reflection as they are printed. Only
 * decaying exponentials occur, so that the tube may be long.
 */
struct Resonator
{
  Complex wave_number;     ///< k [1/m], Im k <= 0
  Complex impedance;       ///< characteristic [Pa s/m^3]
  double length = 0.;      ///< L [m]
  Complex near_reflection; ///< G_0 at z = 0, of waves that come back; 0: they leave
  Complex far_reflection;  ///< G_L at z = L

  /// Pressure [Pa] at z [m] for a wave of pressure P [Pa] that enters at z = 0 (6.22). Throws
  /// std::domain_error at a resonance without losses.
  Complex pressure(double z, Complex entering) const;
  /// Flow rate [m^3/s] (6.23).
  Complex flow_rate(double z, Complex entering) const;
  /// Pressure over flow rate at z (6.24) [Pa s/m^3]; infinite where there is no flow.
  Complex input_impedance(double z) const;
  /// Pressure [Pa] at z if that at z = 0 is prescribed; the near end's reflection has no part in
  /// it.
  Complex pressure_of_prescribed(double z, Complex inlet_pressure) const;

private:
  Complex series() const;
};
} // namespace Continua

#endif
