#ifndef continua_theory_saint_venant_kirchhoff_tube_h
#define continua_theory_saint_venant_kirchhoff_tube_h

#include <continua/theory/tube_section.h>

#include <vector>

namespace Continua
{
/**
 * A tube of layers of the law of Saint-Venant and Kirchhoff, compressible and of any thickness,
 * that is held along its axis. Of the undeformed radius R and r(R) the stretches are r' across and
 * r/R around, Green's strains e = (stretch^2 - 1)/2, the second Piola-Kirchhoff stresses S = lambda
 * (e_across + e_around) + 2 mu e, the first ones P = stretch S, and
 *
 *     dP_across/dR = (P_around - P_across)/R,
 *
 * without a load outside (R. W. Ogden, Non-Linear Elastic Deformations (1984), chapter 5).
 * Integrated inwards from the outer surface by the classical method of Runge and Kutta.
 */
class SaintVenantKirchhoffTube
{
public:
  /// `section` has the undeformed radius and thicknesses. Throws std::invalid_argument where a
  /// layer has another law.
  explicit SaintVenantKirchhoffTube(const TubeSection &section);

  /// [Pa] at the inner radius [m], all branches relaxed; NaN if no state was found.
  double pressure(double inner_radius) const;

private:
  struct Layer
  {
    double inner, outer;    ///< undeformed radii [m]
    double lambda, modulus; ///< Lame's [Pa]
  };
  /// At an undeformed place: the present radius [m] and P across the wall [Pa].
  struct State
  {
    double radius, stress;
  };
  std::vector<Layer> layers; ///< from the inner one

  State rates(const Layer &layer, double place, const State &state) const;
  /// On the inner surface, from the present radius of the outer one [m].
  State inside(double outer_radius) const;
};
} // namespace Continua

#endif
