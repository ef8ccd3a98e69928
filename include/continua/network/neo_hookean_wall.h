#ifndef continua_network_neo_hookean_wall_h
#define continua_network_neo_hookean_wall_h

#include <continua/network/square_root_wall.h>

#include <cmath>

namespace Continua
{
/**
 * Pressure over the area A [m^2] of a thick tube of incompressible neo-Hookean material that is
 * held along its axis. With the area A0 and the area W of the wall's section, without load,
 *
 *     p = p0 + mu/2 (ln((1 + W/A0)/(1 + W/A)) + (A - A0) (1/A - 1/(A + W))),
 *
 * the integral of (stress around - stress across)/r over the wall, as LoadedTube has it by
 * quadrature. It is exact for any strain. There is a largest pressure, p0 + mu/2 ln(1 + W/A0) for A
 * to infinity, where no wave runs.
 */
class NeoHookeanWall
{
public:
  /// A0 and W [m^2], p0 [Pa], and the shear modulus mu [Pa].
  NeoHookeanWall(const double area,
                 const double wall_area,
                 const double pressure,
                 const double shear_modulus)
      : area_without_load(area),
        wall_area(wall_area),
        half_modulus(0.5 * shear_modulus),
        pressure_without_strain(pressure + half_modulus * std::log1p(wall_area / area))
  {
  }

  /// A0 [m^2].
  double reference_area() const { return area_without_load; }
  /// Of A to infinity [Pa]: no area has it.
  double largest_pressure() const { return pressure_without_strain; }
  /// [Pa] at an area [m^2].
  double pressure(const double area) const
  {
    return pressure_without_strain +
           half_modulus * (-std::log1p(wall_area / area) +
                           (area - area_without_load) * wall_area / (area * (area + wall_area)));
  }
  /// dp/dA [Pa/m^2].
  double stiffness(const double area) const
  {
    const double product = area * (area + wall_area);
    return half_modulus * wall_area / product *
           (2. - (area - area_without_load) * (2. * area + wall_area) / product);
  }
  /// Both at once.
  PressureAndStiffness both(const double area) const { return {pressure(area), stiffness(area)}; }
  /// The area [m^2] at a pressure [Pa], by Newton's method from a near one; NaN if there is none.
  double area(const double wanted, const double start) const
  {
    constexpr unsigned int most_iterations = 60;
    constexpr double tolerance = 1e-9; // the error after the last correction is its square
    double area = start;
    for (unsigned int i = 0; i < most_iterations; ++i)
    {
      const double change = (wanted - pressure(area)) / stiffness(area);
      if (!(std::abs(change) < 0.5 * area))
      {
        // Far away, or beyond the largest pressure.
        area *= change > 0. ? 1.5 : 0.5;
        continue;
      }
      area += change;
      if (std::abs(change) < tolerance * area)
        return area;
    }
    return std::nan("");
  }

private:
  double area_without_load; ///< A0 [m^2]
  double wall_area;         ///< W [m^2]
  double half_modulus;      ///< mu/2 [Pa]
  double pressure_without_strain;
};
} // namespace Continua

#endif
