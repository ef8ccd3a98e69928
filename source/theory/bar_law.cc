#include <continua/theory/bar_law.h>

#include <continua/base/six_digits.h>
#include <continua/materials/bulk_relaxation.h>

#include <stdexcept>

namespace Continua
{
namespace
{
/// 2 (1 + nu): Young's modulus over the shear modulus.
double young_over_shear(const double poissons_ratio)
{
  return 2. * (1. + poissons_ratio);
}

Compression elastic_volume(const double youngs_modulus, const double poissons_ratio)
{
  return Compression::elastic(3. * (1. - 2. * poissons_ratio) / youngs_modulus);
}

/// "3 Pa, 4 Pa" of the values from `first` on.
std::string listed(const std::vector<double> &values,
                   const std::size_t first,
                   const std::size_t n,
                   const std::string &unit)
{
  std::string text;
  for (std::size_t k = first; k < first + n; ++k)
    text += (k > first ? ", " : "") + six_digits(values[k]) + " " + unit;
  return text;
}
} // namespace

const std::vector<std::string> &BarLaw::types()
{
  static const std::vector<std::string> types = {"hookean", "kelvin-voigt", "maxwell", "prony",
                                                 "power law"};
  return types;
}

std::vector<BarLawConstant> BarLaw::constants() const
{
  const Dimension modulus = Dimensions::pressure, time = Dimensions::time;
  if (type == "hookean")
    return {{"Young's modulus", modulus}};
  if (type == "kelvin-voigt")
    return {{"Young's modulus", modulus}, {"Viscosity", Dimensions::viscosity}};
  if (type == "maxwell")
    return {{"Shear modulus", modulus}, {"Relaxation time", time}};
  if (type == "power law")
    return {{"Relaxation modulus at one second", modulus}, {"Exponent", Dimensions::none}};
  if (type != "prony")
    throw std::logic_error("there is no law '" + type + "' of a bar");
  std::vector<BarLawConstant> list = {{"Young's modulus", modulus}};
  for (unsigned int k = 1; k <= n_branches; ++k)
    list.push_back({"Shear moduli " + std::to_string(k), modulus});
  for (unsigned int k = 1; k <= n_branches; ++k)
    list.push_back({"Relaxation times " + std::to_string(k), time});
  return list;
}

Material BarLaw::material(const std::vector<double> &constants) const
{
  const bool is_compressible = poissons_ratio < 0.5;
  Material material;
  material.type = type;
  if (type == "power law")
  {
    PowerLaw law;
    law.modulus = constants[0];
    law.exponent = constants[1];
    if (is_compressible)
      law.poissons_ratio = poissons_ratio;
    material.shear.power_law = law;
  }
  else if (type == "maxwell")
  {
    material.shear.branches = {Branch{constants[0], constants[1]}};
    if (is_compressible)
      relax_volume_as_shear(material, poissons_ratio);
  }
  else
  {
    material.shear.branches = {Branch{constants[0] / young_over_shear(poissons_ratio)}};
    material.compression = elastic_volume(constants[0], poissons_ratio);
    if (type == "kelvin-voigt")
      material.shear.viscosity = constants[1];
    for (unsigned int k = 1; type == "prony" && k <= n_branches; ++k)
      material.shear.branches.push_back(Branch{constants[k], constants[n_branches + k]});
    if (type == "prony" && is_compressible)
      relax_volume_as_shear(material, poissons_ratio);
  }
  return material;
}

std::string BarLaw::description() const
{
  if (type == "prony")
    return "a Prony series of " + std::to_string(n_branches) +
           (n_branches == 1 ? " branch" : " branches");
  return type == "power law" ? "a power law" : "a " + type + " solid";
}

std::vector<std::pair<std::string, std::string>>
BarLaw::entries(const std::vector<double> &constants) const
{
  const bool is_compressible = poissons_ratio < 0.5;
  std::vector<std::pair<std::string, std::string>> list = {{"Type", type}};
  const auto add = [&list](const std::string &key, const double value, const std::string &unit)
  { list.emplace_back(key, six_digits(value) + (unit.empty() ? "" : " " + unit)); };
  if (type == "power law")
  {
    add("Relaxation modulus at one second", constants[0], "Pa");
    add("Exponent", constants[1], "");
  }
  else if (type == "maxwell")
  {
    add("Shear modulus", constants[0], "Pa");
    add("Relaxation time", constants[1], "s");
    if (is_compressible)
      add("Bulk modulus",
          constants[0] * young_over_shear(poissons_ratio) / (3. * (1. - 2. * poissons_ratio)),
          "Pa");
    else
      list.emplace_back("Incompressible", "true");
  }
  else
    add("Young's modulus", constants[0], "Pa");
  if (type == "kelvin-voigt")
    add("Viscosity", constants[1], "Pa s");
  if (type == "prony")
  {
    list.emplace_back("Shear moduli", listed(constants, 1, n_branches, "Pa"));
    list.emplace_back("Relaxation times", listed(constants, 1 + n_branches, n_branches, "s"));
  }
  if (type == "hookean" || type == "kelvin-voigt" || type == "prony" ||
      (type == "power law" && is_compressible))
    add("Poisson's ratio", poissons_ratio, "");
  if (is_compressible && (type == "maxwell" || type == "prony" || type == "power law"))
    list.emplace_back("Volumetric relaxation", "as the shear");
  return list;
}
} // namespace Continua
