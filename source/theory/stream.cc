#include <continua/theory/stream.h>

#include <cmath>

namespace Continua
{
double Stream::largest_velocity() const
{
  return profile == StreamProfile::plug ? mean_velocity
                                        : mean_velocity * (exponent + 2.) / exponent;
}

double Stream::velocity(const double s) const
{
  return profile == StreamProfile::plug ? mean_velocity
                                        : largest_velocity() * (1. - std::pow(s, 0.5 * exponent));
}

double Stream::slope(const double s) const
{
  return profile == StreamProfile::plug
             ? 0.
             : -largest_velocity() * 0.5 * exponent * std::pow(s, 0.5 * exponent - 1.);
}
} // namespace Continua
