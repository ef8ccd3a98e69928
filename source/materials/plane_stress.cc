#include <continua/materials/plane_stress.h>

#include <continua/materials/elastic_constants.h>

namespace Continua
{
PlaneStressFactors read_plane_stress_factors(ParameterSection section)
{
  const double nu = ElasticConstants::read(section).poissons_ratio;
  return {(1. + nu) / (1. + 2. * nu), -nu / (1. - nu)};
}
} // namespace Continua
