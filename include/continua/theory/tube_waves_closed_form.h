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
 * (J. Lighthill, Waves in Fluids, section 2.2, with the wall's inertia): of any length, but with
 * neither axial nor bending stiffness of the wall. The long wave has Moens' and Korteweg's speed.
 * `omega` [1/s] and `youngs_modulus` Y [Pa] may be complex. Throws std::domain_error where Re(Y -
 * rho_s R^2 omega^2) <= 0, that is above the wall's ring frequency sqrt(Y/rho_s)/R: the wave does
 * not propagate there.
 */
Complex
inviscid_membrane_wave_number(const ClosedFormTube &tube, Complex omega, Complex youngs_modulus);

/**
 * The same times sqrt(1 / (1 - F10)) of (6.10) for the viscosity. In tubes of h/R up to 0.01 its
 * speed is within 0.5 % of the exact dispersion (2 to 6 % off at 0.05 to 0.1); its attenuation is
 * 40 to 70 % too high for a wall that is axially free, which it takes as held. No reference for
 * amplitudes.
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
 * of the three effects as if each acted alone. The speed is within 0.6 % of the exact one up to f =
 * 1 / duration of the pulse, the attenuation up to 13 % low.
 */
Complex closed_form_wave_number(const ClosedFormTube &tube,
                                Complex omega,
                                Complex youngs_modulus,
                                Anchoring anchoring = Anchoring::expansion_joints);
} // namespace Continua

#endif
