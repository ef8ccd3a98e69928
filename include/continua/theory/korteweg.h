#ifndef continua_theory_korteweg_h
#define continua_theory_korteweg_h

#include <continua/theory/complex_bessel.h>

namespace Continua
{
/// How a tube is held axially (table 6.1 of the thesis).
enum class Anchoring
{
  upstream,        ///< at its upstream end only: the wall carries the thrust of the pressure
  throughout,      ///< everywhere: no axial strain
  expansion_joints ///< nowhere: no axial stress. So also the early pulse between two clamped ends.
};

/// How the wall's stress is taken to vary over its thickness.
enum class WallTheory
{
  thin, ///< not at all; for h / (2 R) < 1/20
  thick ///< as Lame's: exact for a long wave
};

/**
 * psi of table 6.1 [1], after E. B. Wylie, V. L. Streeter, Fluid Transients in Systems (1993): the
 * relative change of section with pressure is psi 2 R / (Y h).
 *
 *     anchoring          thin       thick
 *     upstream           1 - nu/2   (h/R)(1 + nu) + 2R/(2R + h) (1 - nu/2)
 *     throughout         1 - nu^2   (h/R)(1 + nu) + 2R/(2R + h) (1 - nu^2)
 *     expansion joints   1          (h/R)(1 + nu) + 2R/(2R + h)
 *
 * The thick column is Lame's solution with the axial stress of closed ends p R^2/(Ro^2 - R^2), with
 * no axial strain, and with no axial stress. (The thesis prints plus signs in the thick column's
 * parentheses; its own thin column is then not the limit for h -> 0, and Lame's solution is
 * not met. In older editions of the book the first row is 5/4 - nu.)
 */
double anchoring_coefficient(Anchoring anchoring,
                             WallTheory wall,
                             double inner_radius,
                             double wall_thickness,
                             double poissons_ratio);

/// What determines the speed of long waves in a liquid-filled tube.
struct LongWaveTube
{
  double inner_radius = 0.;         ///< R [m]
  double wall_thickness = 0.;       ///< h [m]; 0: the wall is rigid
  double poissons_ratio = 0.5;      ///< nu of the wall
  double density = 0.;              ///< rho_f of the fluid [kg/m^3]
  double inverse_bulk_modulus = 0.; ///< 1/K of the fluid [1/Pa]
};

/// c1 = sqrt(K / rho_f) (6.17) [m/s]: the speed of sound in the liquid; infinite if incompressible.
double acoustic_speed(double density, double inverse_bulk_modulus);

/// c0 = sqrt(Y h / (2 R rho_f)) (6.18 with psi = 1) [m/s], after Moens and Korteweg (1878).
/// `youngs_modulus` [Pa], complex at a frequency for a viscoelastic wall.
Complex moens_korteweg_speed(const LongWaveTube &tube, Complex youngs_modulus);

/// c of (6.15) [m/s]: 1/c^2 = rho_f (1/K + psi 2 R / (Y h)) (6.16), without inertia of the wall; in
/// a rigid tube the speed of sound.
Complex korteweg_speed(const LongWaveTube &tube,
                       Complex youngs_modulus,
                       Anchoring anchoring,
                       WallTheory wall);

/// Characteristic impedance rho c / A (6.19) [Pa s/m^3] of an inviscid wave; `speed` [m/s] may be
/// complex. With viscosity see Womersley::characteristic_impedance.
Complex characteristic_impedance(double density, Complex speed, double area);
} // namespace Continua

#endif
