#include <continua/materials/strain_law_parameters.h>

#include <continua/materials/strain_law_types.h>

#include <cmath>

namespace Continua
{
void StrainLawParameters::read(ParameterSection &section, const bool incompressible)
{
  std::vector<std::string> names;
  std::string text = "The law of large strains:";
  for (const StrainLawType &row : strain_law_types())
  {
    names.push_back(row.name);
    text += " " + row.name + " - " + row.description;
  }
  section.add_choice("Strain law", type, names, text);
  const StrainLawType &row = strain_law_type(type);
  if (row.needs_bulk_modulus && incompressible)
    section.refuse("Strain law",
                   "the law '" + type +
                       "' has no incompressible form, as its pressure follows "
                       "from the strain",
                   "Give a Poisson's ratio below 0.5, or the law neo hookean");
  row.read(section, *this);
}

bool StrainLawParameters::has_fibres() const
{
  return strain_law_type(type).has_fibres;
}

std::vector<dealii::Tensor<1, 3>>
StrainLawParameters::fibres(const dealii::Tensor<1, 3> &axis,
                            const dealii::Tensor<1, 3> &circumference) const
{
  if (!has_fibres())
    return {};
  const dealii::Tensor<1, 3> along = std::cos(fibre_angle) * axis,
                             around = std::sin(fibre_angle) * circumference;
  return {along + around, along - around};
}
} // namespace Continua
