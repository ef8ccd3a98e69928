#include <continua/theory/korteweg.h>

#include <cmath>

namespace Continua
{
double anchoring_coefficient(const Anchoring anchoring,
                             const WallTheory wall,
                             const double inner_radius,
                             const double wall_thickness,
                             const double poissons_ratio)
{
  const double nu = poissons_ratio;
  const double thin = anchoring == Anchoring::upstream     ? 1. - 0.5 * nu
                      : anchoring == Anchoring::throughout ? 1. - nu * nu
                                                           : 1.;
  if (wall == WallTheory::thin)
    return thin;
  return wall_thickness / inner_radius * (1. + nu) +
         2. * inner_radius / (2. * inner_radius + wall_thickness) * thin;
}

double acoustic_speed(const double density, const double inverse_bulk_modulus)
{
  return 1. / std::sqrt(density * inverse_bulk_modulus);
}

Complex moens_korteweg_speed(const LongWaveTube &tube, const Complex youngs_modulus)
{
  return std::sqrt(youngs_modulus * tube.wall_thickness / (2. * tube.inner_radius * tube.density));
}

Complex korteweg_speed(const LongWaveTube &tube,
                       const Complex youngs_modulus,
                       const Anchoring anchoring,
                       const WallTheory wall)
{
  if (tube.wall_thickness == 0.)
    return acoustic_speed(tube.density, tube.inverse_bulk_modulus);
  const double psi = anchoring_coefficient(anchoring, wall, tube.inner_radius, tube.wall_thickness,
                                           tube.poissons_ratio);
  const Complex distensibility =
      psi * 2. * tube.inner_radius / (youngs_modulus * tube.wall_thickness);
  return 1. / std::sqrt(tube.density * (tube.inverse_bulk_modulus + distensibility));
}

Complex characteristic_impedance(const double density, const Complex speed, const double area)
{
  return density * speed / area;
}
} // namespace Continua
