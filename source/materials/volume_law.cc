#include <continua/materials/volume_law.h>

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>

namespace Continua
{
double VolumeLaw::energy(const double pressure) const
{
  if (inverse_bulk_modulus == 0.)
    return 0.;
  // In closed form the terms cancel where the pressure is small against K.
  const double change = pressure - reference_pressure;
  const auto integrand = [&](const double part)
  {
    const double between = reference_pressure + part * change;
    return between * compressibility(between) / density_ratio(between);
  };
  return density_ratio(pressure) * change *
         boost::math::quadrature::gauss<double, 10>::integrate(integrand, 0., 1.);
}

double VolumeLaw::density_ratio_of_compressible(const double pressure) const
{
  if (exponent == 0.)
    return std::exp((pressure - reference_pressure) * inverse_bulk_modulus);
  // A power of a sum next to 1 would lose the digits of a small exponent.
  return std::exp(std::log1p(exponent * (pressure - reference_pressure) * inverse_bulk_modulus) /
                  exponent);
}
} // namespace Continua
