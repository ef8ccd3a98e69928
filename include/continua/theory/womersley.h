#ifndef continua_theory_womersley_h
#define continua_theory_womersley_h

#include <continua/theory/complex_bessel.h>

namespace Continua
{
/**
 * Viscous flow exp(i omega t) in a round tube that is long in comparison to its radius, after J. R.
 * Womersley, J. Physiol. 127 (1955) 553 and Phil. Mag. 46 (1955) 199; equation numbers are the
 * thesis's. All its functions take omega [1/s] real or complex, and 0 where the limit, the flow of
 * Poiseuille, is finite.
 *
 * The slips of the thesis's text: eta in (6.9) is the kinematic viscosity; (6.12) is to be c =
 * omega / Re k, and -Im k, not Re k, is the damping coefficient.
 */
class Womersley
{
public:
  /// `radius` [m], `density` [kg/m^3], dynamic `viscosity` [Pa s]; 0 is an inviscid fluid. Throws
  /// std::invalid_argument for values that are not.
  Womersley(double radius, double density, double viscosity);

  /// Womersley's number alpha = R sqrt(omega / nu) (6.9) [1]; infinite if inviscid.
  double number(double omega) const;
  /// Thickness of the oscillating boundary layer sqrt(2 nu / omega) [m].
  double layer_thickness(double omega) const;

  /// F10 = 2 J1(z) / (z J0(z)), z = i^(3/2) alpha (6.11) [1]: 1 for a slow, 0 for a fast or
  /// inviscid flow.
  Complex f10(Complex omega) const;
  /// 1 - F10 = -J2(z)/J0(z) [1], without the cancellation that the difference has at small alpha.
  Complex one_minus_f10(Complex omega) const;

  /// Wave number k = omega / c0 sqrt(1 / (1 - F10)) (6.10) [1/m], Re k > 0 for omega > 0, of an
  /// axially held wall. `long_wave_speed` c0 [m/s], complex for a viscoelastic wall.
  Complex wave_number(Complex omega, Complex long_wave_speed) const;

  /// Axial velocity [m/s] at the distance r [m] from the axis of a rigid tube: dp/dz i / (rho
  /// omega) (1 - J0(z r/R)/J0(z)). `pressure_gradient` dp/dz [Pa/m].
  Complex velocity(Complex omega, Complex pressure_gradient, double r) const;
  /// The same for unit mean velocity over the section [1]: the profile of a given flow rate.
  Complex profile(Complex omega, double r) const;
  /// Flow rate [m^3/s]: dp/dz i pi R^2 / (rho omega) (1 - F10).
  Complex flow_rate(Complex omega, Complex pressure_gradient) const;
  /// Shear stress [Pa] that the fluid exerts on the wall towards +z: -R/2 dp/dz F10.
  Complex wall_shear_stress(Complex omega, Complex pressure_gradient) const;
  /// Pressure over flow rate [Pa s/m^3] of the wave exp(i(omega t - k z)): rho omega / (k pi R^2
  /// (1 - F10)); rho c / A of (6.19) if inviscid.
  Complex characteristic_impedance(Complex omega, Complex wave_number) const;

private:
  double radius, density, viscosity;

  double area() const;
  Complex stokes_argument(Complex omega) const;
};

/// Phase speed omega / Re k [m/s] (6.12, corrected).
double phase_speed(double omega, Complex wave_number);
/// Attenuation -Im k [1/m]: the amplitude falls as its exponential.
double attenuation(Complex wave_number);
} // namespace Continua

#endif
