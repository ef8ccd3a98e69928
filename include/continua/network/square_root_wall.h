#ifndef continua_network_square_root_wall_h
#define continua_network_square_root_wall_h

#include <cmath>
#include <limits>

namespace Continua
{
/// Of a section of a vessel.
struct PressureAndStiffness
{
  double pressure;  ///< [Pa]
  double stiffness; ///< dp/dA [Pa/m^2]
};

/**
 * Pressure over the area A [m^2] of a section of a tube with a wall of small strain,
 *
 *     p = p0 + beta (sqrt(A) - sqrt(A0)),
 *
 * the tube law of the field (L. Formaggia, D. Lamponi, A. Quarteroni, J. Eng. Math. 47 (2003) 251).
 * beta follows from the speed c0 of long waves at the area A0: A dp/dA = rho c^2 gives beta = 2 rho
 * c0^2/sqrt(A0). For a thin wall that is held along its axis it is sqrt(pi) Y h/((1 - nu^2) A0).
 */
class SquareRootWall
{
public:
  /// `pressure` p0 [Pa] at the area A0 [m^2]; rho c0^2 [Pa] there.
  SquareRootWall(const double area, const double pressure, const double density_times_speed_squared)
      : reference_pressure(pressure),
        reference_root(std::sqrt(area)),
        beta(2. * density_times_speed_squared / reference_root)
  {
  }

  /// A0 [m^2].
  double reference_area() const { return reference_root * reference_root; }
  /// There is none [Pa].
  double largest_pressure() const { return std::numeric_limits<double>::infinity(); }
  /// [Pa] at an area [m^2].
  double pressure(const double area) const
  {
    return reference_pressure + beta * (std::sqrt(area) - reference_root);
  }
  /// dp/dA [Pa/m^2].
  double stiffness(const double area) const { return 0.5 * beta / std::sqrt(area); }
  /// Both at once.
  PressureAndStiffness both(const double area) const
  {
    const double root = std::sqrt(area);
    return {reference_pressure + beta * (root - reference_root), 0.5 * beta / root};
  }
  /// The area [m^2] at a pressure [Pa]; NaN where the tube is closed. `start` is of no use here.
  double area(const double pressure, const double /*start*/) const
  {
    const double root = reference_root + (pressure - reference_pressure) / beta;
    return root > 0. ? root * root : std::nan("");
  }

private:
  double reference_pressure; ///< p0 [Pa]
  double reference_root;     ///< sqrt(A0) [m]
  double beta;               ///< [Pa/m]
};
} // namespace Continua

#endif
