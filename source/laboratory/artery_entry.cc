#include <continua/laboratory/artery_entry.h>

#include <continua/base/six_digits.h>

#include <deal.II/base/numbers.h>

namespace Continua
{
namespace
{
using Scale = FitParameter::Scale;
constexpr double degree = dealii::numbers::PI / 180.;

/// A constant of the strain law.
ArteryEntry entry_of_law(const std::string &key,
                         const Dimension &dimension,
                         const bool is_angle,
                         const std::string &strain_law,
                         const double lower,
                         const double upper,
                         const Scale scale,
                         double StrainLawParameters::*const member)
{
  return {key,
          dimension,
          is_angle,
          strain_law,
          lower,
          upper,
          scale,
          [member](const Material &material) { return material.strain_law_parameters.*member; },
          [member](Material &material, const double value)
          { material.strain_law_parameters.*member = value; }};
}
} // namespace

std::string ArteryEntry::unit() const
{
  return is_angle ? "rad" : dimension == Dimensions::none ? "1" : dimension.unit();
}

std::string ArteryEntry::text(const double value) const
{
  if (is_angle)
    return six_digits(value / degree) + " deg";
  return six_digits(value) + (dimension == Dimensions::none ? "" : " " + dimension.unit());
}

const std::vector<ArteryEntry> &artery_entries()
{
  const std::string fibres = "holzapfel gasser ogden";
  using Parameters = StrainLawParameters;
  static const std::vector<ArteryEntry> rows = {
      {"Young's modulus", Dimensions::pressure, false, "", 1., 1e10, Scale::logarithmic,
       // Three times the shear modulus: the layers are incompressible.
       [](const Material &material) { return 3. * material.long_term_shear_modulus(); },
       [](Material &material, const double value)
       { material.shear.branches.front().shear_modulus = value / 3.; }},
      entry_of_law("Mooney-Rivlin share", Dimensions::none, false, "mooney rivlin", 0., 1.,
                   Scale::linear, &Parameters::mooney_rivlin_share),
      entry_of_law("Fibre stiffness", Dimensions::pressure, false, fibres, 1., 1e10,
                   Scale::logarithmic, &Parameters::fibre_stiffness),
      entry_of_law("Fibre exponent", Dimensions::none, false, fibres, 1e-3, 1e3, Scale::logarithmic,
                   &Parameters::fibre_exponent),
      entry_of_law("Fibre dispersion", Dimensions::none, false, fibres, 0., 1. / 3., Scale::linear,
                   &Parameters::fibre_dispersion),
      entry_of_law("Fibre angle", Dimensions::none, true, fibres, 0., 90. * degree, Scale::linear,
                   &Parameters::fibre_angle),
      {"Opening angle", Dimensions::none, true, "", 0., 340. * degree, Scale::linear,
       [](const Material &material) { return material.prestretch.opening_angle; },
       [](Material &material, const double value) { material.prestretch.opening_angle = value; }}};
  return rows;
}

const ArteryEntry *find_artery_entry(const std::string &key)
{
  for (const ArteryEntry &row : artery_entries())
    if (row.key == key)
      return &row;
  return nullptr;
}
} // namespace Continua
