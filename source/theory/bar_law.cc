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

/// A material whose volume change is elastic.
Material
elastic_volume(const std::string &type, const double youngs_modulus, const double poissons_ratio)
{
  Material material;
  material.type = type;
  material.shear.branches = {Branch{youngs_modulus / young_over_shear(poissons_ratio)}};
  material.compression = Compression::elastic(3. * (1. - 2. * poissons_ratio) / youngs_modulus);
  return material;
}

/// A spring, or with branches a Prony series.
class SeriesLaw : public BarLaw
{
public:
  SeriesLaw(const double poissons_ratio, const unsigned int n)
      : BarLaw(poissons_ratio), n(n), is_hookean(n == 0)
  {
  }
  unsigned int n_branches() const override { return n; }
  bool is_series() const override { return true; }
  std::string type() const override { return is_hookean ? "hookean" : "prony"; }
  std::string description() const override
  {
    return is_hookean
               ? BarLaw::description()
               : "a Prony series of " + std::to_string(n) + (n == 1 ? " branch" : " branches");
  }
  std::vector<BarLawConstant> constants() const override
  {
    std::vector<BarLawConstant> list = {{"Young's modulus", Dimensions::pressure}};
    for (unsigned int k = 1; k <= n; ++k)
      list.push_back({"Shear moduli " + std::to_string(k), Dimensions::pressure});
    for (unsigned int k = 1; k <= n; ++k)
      list.push_back({"Relaxation times " + std::to_string(k), Dimensions::time});
    return list;
  }
  Material material(const std::vector<double> &constants) const override
  {
    Material material = elastic_volume(type(), constants[0], poissons_ratio);
    for (unsigned int k = 1; k <= n; ++k)
      material.shear.branches.push_back(Branch{constants[k], constants[n + k]});
    if (!is_hookean && is_compressible())
      relax_volume_as_shear(material, poissons_ratio);
    return material;
  }
  Entries entries(const std::vector<double> &constants) const override
  {
    Entries list = {{"Type", type()}, {"Young's modulus", six_digits(constants[0]) + " Pa"}};
    if (!is_hookean)
    {
      list.emplace_back("Shear moduli", listed(constants, 1, n, "Pa"));
      list.emplace_back("Relaxation times", listed(constants, 1 + n, n, "s"));
    }
    list.emplace_back("Poisson's ratio", six_digits(poissons_ratio));
    if (!is_hookean && is_compressible())
      list.emplace_back("Volumetric relaxation", "as the shear");
    return list;
  }
  std::vector<double> unit_constants(double) const override
  {
    if (!is_hookean)
      throw std::logic_error("a Prony series has more than one constant to scan");
    return {1.};
  }

private:
  const unsigned int n;
  const bool is_hookean;
};

class KelvinVoigtLaw : public BarLaw
{
public:
  using BarLaw::BarLaw;
  std::string type() const override { return "kelvin-voigt"; }
  /// Its stress is constant from the end of the loading on.
  bool is_shown_by_relaxation() const override { return false; }
  std::vector<BarLawConstant> constants() const override
  {
    return {{"Young's modulus", Dimensions::pressure}, {"Viscosity", Dimensions::viscosity}};
  }
  Material material(const std::vector<double> &constants) const override
  {
    Material material = elastic_volume(type(), constants[0], poissons_ratio);
    material.shear.viscosity = constants[1];
    return material;
  }
  Entries entries(const std::vector<double> &constants) const override
  {
    return {{"Type", type()},
            {"Young's modulus", six_digits(constants[0]) + " Pa"},
            {"Viscosity", six_digits(constants[1]) + " Pa s"},
            {"Poisson's ratio", six_digits(poissons_ratio)}};
  }
  std::vector<double> unit_constants(const double time) const override
  {
    return {1., time * (1. / young_over_shear(poissons_ratio))};
  }
};

class MaxwellLaw : public BarLaw
{
public:
  using BarLaw::BarLaw;
  std::string type() const override { return "maxwell"; }
  std::vector<BarLawConstant> constants() const override
  {
    return {{"Shear modulus", Dimensions::pressure}, {"Relaxation time", Dimensions::time}};
  }
  Material material(const std::vector<double> &constants) const override
  {
    Material material;
    material.type = type();
    material.shear.branches = {Branch{constants[0], constants[1]}};
    if (is_compressible())
      relax_volume_as_shear(material, poissons_ratio);
    return material;
  }
  Entries entries(const std::vector<double> &constants) const override
  {
    Entries list = {{"Type", type()},
                    {"Shear modulus", six_digits(constants[0]) + " Pa"},
                    {"Relaxation time", six_digits(constants[1]) + " s"}};
    if (is_compressible())
    {
      const double bulk_modulus =
          constants[0] * young_over_shear(poissons_ratio) / (3. * (1. - 2. * poissons_ratio));
      list.emplace_back("Bulk modulus", six_digits(bulk_modulus) + " Pa");
      list.emplace_back("Volumetric relaxation", "as the shear");
    }
    else
      list.emplace_back("Incompressible", "true");
    return list;
  }
  std::vector<double> unit_constants(const double time) const override
  {
    return {1. / young_over_shear(poissons_ratio), time};
  }
};

class PowerLawOfBar : public BarLaw
{
public:
  using BarLaw::BarLaw;
  std::string type() const override { return "power law"; }
  std::string description() const override { return "a power law"; }
  std::vector<BarLawConstant> constants() const override
  {
    return {{"Relaxation modulus at one second", Dimensions::pressure},
            {"Exponent", Dimensions::none}};
  }
  Material material(const std::vector<double> &constants) const override
  {
    PowerLaw law;
    law.modulus = constants[0];
    law.exponent = constants[1];
    if (is_compressible())
      law.poissons_ratio = poissons_ratio;
    Material material;
    material.type = type();
    material.shear.power_law = law;
    return material;
  }
  Entries entries(const std::vector<double> &constants) const override
  {
    Entries list = {{"Type", type()},
                    {"Relaxation modulus at one second", six_digits(constants[0]) + " Pa"},
                    {"Exponent", six_digits(constants[1])}};
    if (is_compressible())
    {
      list.emplace_back("Poisson's ratio", six_digits(poissons_ratio));
      list.emplace_back("Volumetric relaxation", "as the shear");
    }
    return list;
  }
  std::vector<double> unit_constants(const double exponent) const override
  {
    return {1., exponent};
  }
};

using Maker = std::shared_ptr<const BarLaw> (*)(double poissons_ratio, unsigned int n_branches);

template <typename Law>
std::shared_ptr<const BarLaw> make(const double poissons_ratio, unsigned int)
{
  return std::make_shared<const Law>(poissons_ratio);
}

std::shared_ptr<const BarLaw> make_hookean(const double poissons_ratio, unsigned int)
{
  return make_series_of_bar(poissons_ratio, 0);
}

std::shared_ptr<const BarLaw> make_prony(const double poissons_ratio, const unsigned int n_branches)
{
  if (n_branches == 0)
    throw std::logic_error("a Prony series has one branch at least");
  return make_series_of_bar(poissons_ratio, n_branches);
}

const std::vector<std::pair<std::string, Maker>> &makers()
{
  static const std::vector<std::pair<std::string, Maker>> rows = {
      {"hookean", make_hookean},
      {"kelvin-voigt", make<KelvinVoigtLaw>},
      {"maxwell", make<MaxwellLaw>},
      {"prony", make_prony},
      {"power law", make<PowerLawOfBar>}};
  return rows;
}
} // namespace

std::shared_ptr<const BarLaw> make_series_of_bar(const double poissons_ratio,
                                                 const unsigned int n_branches)
{
  return std::make_shared<const SeriesLaw>(poissons_ratio, n_branches);
}

std::vector<std::string> bar_law_types()
{
  std::vector<std::string> types;
  for (const auto &row : makers())
    types.push_back(row.first);
  return types;
}

std::shared_ptr<const BarLaw>
make_bar_law(const std::string &type, const double poissons_ratio, const unsigned int n_branches)
{
  for (const auto &[name, maker] : makers())
    if (name == type)
      return maker(poissons_ratio, n_branches);
  throw std::logic_error("there is no law '" + type + "' of a bar");
}
} // namespace Continua
