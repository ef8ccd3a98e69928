#ifndef continua_materials_strain_law_types_h
#define continua_materials_strain_law_types_h

#include <continua/materials/strain_law.h>
#include <continua/materials/strain_law_parameters.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// A constant of a law that a measured curve determines.
struct StrainLawConstant
{
  std::string key; ///< of the parameter file
  Dimension dimension;
  double StrainLawParameters::*member;
  bool is_share; ///< whether it lies between 0 and 1; else it is positive
  double usual;  ///< where the search for it begins if the parameter file has 0
};

/// A row of the table of hyperelastic laws.
struct StrainLawType
{
  std::string name;        ///< as in parameter files
  std::string description; ///< one line, for the manual
  bool has_fibres;         ///< whether it has directions of fibres
  bool needs_bulk_modulus; ///< whether the material must be compressible
  /// Beside the shear modulus.
  std::vector<StrainLawConstant> constants;
  /// Declares and reads the entries of this law. Throws InputError.
  std::function<void(ParameterSection &, StrainLawParameters &)> read;
  /// From the parameters, the shear modulus mu and the bulk modulus K [Pa].
  std::function<std::unique_ptr<StrainLaw>(const StrainLawParameters &, double, double)> make;
};

/// The hyperelastic laws: a row here, beside the law's own file pair, puts a law into the parameter
/// files and the manual.
const std::vector<StrainLawType> &strain_law_types();

/// The row of that name; throws std::logic_error if there is none.
const StrainLawType &strain_law_type(const std::string &name);

/// The law of a material with that shear modulus at zero strain and bulk modulus [Pa] (infinite:
/// incompressible).
std::unique_ptr<StrainLaw>
make_strain_law(const StrainLawParameters &parameters, double shear_modulus, double bulk_modulus);
} // namespace Continua

#endif
