#ifndef continua_theory_tube_waves_closed_form_h
#define continua_theory_tube_waves_closed_form_h

#include <continua/theory/korteweg.h>

namespace Continua
{
/// A uniform tube for the closed formulas of its pressure wave.
struct ClosedFormTube
{
  LongWaveTube tube;
  double viscosity = 0.;    ///< eta of the fluid, dynamic [Pa s]
  double wall_density = 0.; ///< rho_s [kg/m^3]
};

/**
 * Wave number k [1/m] of the pressure wave exp(i(omega t - k z)) in a membrane around an inviscid
 * incompressible fluid,
 *
 *     omega^2 = (Y h / R^2) / (rho_f I0(kR) / (k I1(kR)) + rho_s h)
 *
 * from the fluid's potential I0(kr) and the wall's radial balance, p over u_r being Y h/R^2 less
 * rho_s h omega^2: of any length, but with neither axial nor bending stiffness of the wall. The
 * long wave has Moens' and Korteweg's speed. `omega` [1/s] and `youngs_modulus` Y [Pa] may be
 * complex. Throws std::domain_error where Re(Y - rho_s R^2 omega^2) <= 0, that is above the wall's
 * ring frequency sqrt(Y/rho_s)/R: the wave does not propagate there.
 */
Complex
inviscid_membrane_wave_number(const ClosedFormTube &tube, Complex omega, Complex youngs_modulus);

/**
 * The same times sqrt(1 / (1 - F10)) of (6.10) for the viscosity. For an axially free wall of h/R
 * up to 0.01 its speed is within 0.5 % of the exact dispersion (up to 6 % too high for h/R 0.05 to
 * 0.1), its attenuation 15 to 71 % too high, since it takes the wall as held for the friction
 * (tests/theory/closed_form_against_exact.cc). No reference for amplitudes.
 */
Complex membrane_wave_number(const ClosedFormTube &tube, Complex omega, Complex youngs_modulus);

/**
 * Closed formula for a thick wall:
 *
 *     k = omega sqrt(rho_f (1/K + psi 2R/(Y h))) * (k_membrane / k_long) * sqrt(1 / (1 - a^2 F10))
 *
 * with the thick wall's psi (table 6.1), k_membrane of inviscid_membrane_wave_number, its long-wave
 * limit k_long = omega sqrt(2 R rho_f / (Y h)), and a = 1 - nu/2 for a wall that is axially free
 * and moves with the fluid; a = 1 if it is held (Anchoring::throughout). It joins the exact limits
 * of the three effects as if each acted alone. In the tubes of h/R 0.008 to 0.2 of
 * tests/theory/closed_form_against_exact.cc, up to 20 Hz, the speed is within 0.6 % of the exact
 * one and the attenuation up to 13 % too low; beyond, in tube A at 40 Hz, it is 38 % too low.
 */
Complex closed_form_wave_number(const ClosedFormTube &tube,
                                Complex omega,
                                Complex youngs_modulus,
                                Anchoring anchoring = Anchoring::expansion_joints);
} // namespace Continua

#endif
