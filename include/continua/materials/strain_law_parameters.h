#ifndef continua_materials_strain_law_parameters_h
#define continua_materials_strain_law_parameters_h

#include <continua/base/parameter_section.h>

#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace Continua
{
/// The hyperelastic law of a solid, beside its shear modulus and its bulk modulus.
struct StrainLawParameters
{
  std::string type = "neo hookean"; ///< a row of strain_law_types()
  double mooney_rivlin_share = 0.;  ///< mu2/(mu1 + mu2) [1]
  double fibre_stiffness = 0.;      ///< k1 [Pa]
  double fibre_exponent = 0.;       ///< k2 [1]
  double fibre_dispersion = 0.;     ///< kappa [1]
  double fibre_angle = 0.;          ///< of both families from the axis [rad]

  /// Declares and reads the law and the entries that it has in the section of the material.
  /// `incompressible`: whether the material is. Throws InputError.
  void read(ParameterSection &section, bool incompressible);
  bool has_fibres() const;
  /// Unit vectors of both families, at +- the angle from the `axis` towards the `circumference`
  /// (unit vectors, at right angles); empty for a law without fibres.
  std::vector<dealii::Tensor<1, 3>> fibres(const dealii::Tensor<1, 3> &axis,
                                           const dealii::Tensor<1, 3> &circumference) const;
};
} // namespace Continua

#endif
