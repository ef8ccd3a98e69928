#include <continua/materials/volume_law.h>

#include <cmath>

namespace Continua
{
double VolumeLaw::stiffening(const double pressure) const
{
  return 1. + exponent * (pressure - reference_pressure) * inverse_bulk_modulus;
}

double VolumeLaw::compressibility(const double pressure) const
{
  return inverse_bulk_modulus / stiffening(pressure);
}

double VolumeLaw::compressibility_slope(const double pressure) const
{
  const double c = compressibility(pressure);
  return -exponent * c * c;
}

double VolumeLaw::density_ratio(const double pressure) const
{
  if (exponent == 0.)
    return std::exp((pressure - reference_pressure) * inverse_bulk_modulus);
  return std::pow(stiffening(pressure), 1. / exponent);
}
} // namespace Continua
