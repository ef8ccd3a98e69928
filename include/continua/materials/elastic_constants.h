#ifndef continua_materials_elastic_constants_h
#define continua_materials_elastic_constants_h

#include <continua/base/parameter_section.h>

namespace Continua
{
/// The two constants by which a parameter file describes an elastic solid.
struct ElasticConstants
{
  double youngs_modulus; ///< Y [Pa]; of a viscoelastic solid the long-term one
  double poissons_ratio; ///< nu [1]

  /// Declares and reads them in a child of the section Materials. Throws InputError.
  static ElasticConstants read(ParameterSection &section);
  double shear_modulus() const { return youngs_modulus / (2. * (1. + poissons_ratio)); } ///< [Pa]
};
} // namespace Continua

#endif
