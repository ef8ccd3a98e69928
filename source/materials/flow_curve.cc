#include <continua/materials/flow_curve.h>

#include <cmath>

namespace Continua
{
double FlowCurve::viscosity(const double rate) const
{
  const double thinning =
      std::pow(1. + std::pow(time * rate, yasuda_exponent), (index - 1.) / yasuda_exponent);
  return infinite_rate_viscosity + (zero_rate_viscosity - infinite_rate_viscosity) * thinning;
}

double FlowCurve::slope_over_rate(const double rate) const
{
  if (rate == 0.)
    return 0.;
  const double power = std::pow(time * rate, yasuda_exponent);
  return (zero_rate_viscosity - infinite_rate_viscosity) * (index - 1.) * power / rate / rate *
         std::pow(1. + power, (index - 1.) / yasuda_exponent - 1.);
}
} // namespace Continua
