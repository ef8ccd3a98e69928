#include <continua/materials/elastic_constants.h>

#include <continua/base/required_entry.h>

namespace Continua
{
ElasticConstants ElasticConstants::read(ParameterSection &section)
{
  const double youngs_modulus = required_entry(
      section, "Young's modulus", Dimensions::pressure,
      "Young's modulus Y; of a viscoelastic solid the long-term one.", Range::positive());
  const double poissons_ratio =
      required_entry(section, "Poisson's ratio", Dimensions::none,
                     "Poisson's ratio nu; 0.5 is incompressible.", Range{-1., 0.5, true, false});
  return {youngs_modulus, poissons_ratio};
}
} // namespace Continua
