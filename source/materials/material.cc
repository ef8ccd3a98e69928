#include <continua/materials/material.h>

#include <continua/base/required_entry.h>
#include <continua/base/words.h>
#include <continua/materials/bulk_relaxation.h>
#include <continua/materials/elastic_constants.h>
#include <continua/materials/relaxation_test.h>
#include <continua/materials/strain_law_types.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Continua
{
namespace
{
double read_density(ParameterSection &section)
{
  return required_entry(section, "Density", Dimensions::density, "Density rho.", Range::positive());
}

/// Of a material that is described by its bulk modulus, or incompressible.
Compression read_compression(ParameterSection &section)
{
  bool incompressible = false;
  section.add("Incompressible", incompressible,
              "Whether the volume cannot change (1/K = 0); then no bulk modulus is given.");
  double bulk_modulus = std::numeric_limits<double>::quiet_NaN();
  section.add("Bulk modulus", bulk_modulus, Dimensions::pressure,
              "Bulk modulus K. Required unless incompressible.", Range::positive());
  if (incompressible && section.given("Bulk modulus"))
    section.refuse("Bulk modulus", "a bulk modulus is given for an incompressible material",
                   "Remove it, or set Incompressible = false");
  if (!incompressible)
    section.require("Bulk modulus");
  return incompressible ? Compression() : Compression::elastic(1. / bulk_modulus);
}

/// Young's modulus and Poisson's ratio -> shear and bulk modulus (equations 2.4, 2.5); returns mu.
double read_elasticity(ParameterSection &section, const Model model, Material &material)
{
  const ElasticConstants constants = ElasticConstants::read(section);
  const double young = constants.youngs_modulus, nu = constants.poissons_ratio;
  const double mu = constants.shear_modulus();
  if (model == Model::plane_stress)
  {
    const double lambda = young * nu / ((1. + nu) * (1. - nu));
    const double inverse_bulk_modulus = 1. / (lambda + 2. / 3. * mu);
    if (inverse_bulk_modulus <= 0.)
      section.refuse("Poisson's ratio",
                     "in plane stress the velocity-pressure form needs a ratio above -0.5",
                     "Give a ratio between -0.5 and 0.5");
    material.compression = Compression::elastic(inverse_bulk_modulus);
  }
  else
    material.compression = Compression::elastic(3. * (1. - 2. * nu) / young);
  return mu;
}

void refuse_plane_stress(const ParameterSection &section, const Model model)
{
  if (model == Model::plane_stress)
    section.refuse("Type",
                   "plane stress is for Hookean solids only: with viscosity or relaxation the "
                   "strain across the "
                   "plane depends on history",
                   "Use 'hookean' here, or Model = plane strain or three-dimensional");
}

enum class VolumetricRelaxation
{
  none,
  as_shear,
  own_branches
};

/// How the volume change relaxes; by branches of its own if the law can.
VolumetricRelaxation read_volumetric_relaxation(ParameterSection &section,
                                                const bool with_own_branches,
                                                const std::string &text)
{
  Words<VolumetricRelaxation> words = {{"none", VolumetricRelaxation::none},
                                       {"as the shear", VolumetricRelaxation::as_shear}};
  if (with_own_branches)
    words.emplace_back("own branches", VolumetricRelaxation::own_branches);
  VolumetricRelaxation choice = VolumetricRelaxation::none;
  add_choice(section, "Volumetric relaxation", choice, words,
             "How the pressure of a volume change relaxes: " + text);
  return choice;
}

/// Moduli and times of as many branches; `kind`: "shear moduli" or "bulk moduli", for messages.
void require_pairs(const ParameterSection &section,
                   const std::vector<double> &moduli,
                   const std::vector<double> &times,
                   const std::string &times_key,
                   const std::string &kind)
{
  if (moduli.size() != times.size())
    section.refuse(times_key,
                   std::to_string(moduli.size()) + " " + kind + " stand beside " +
                       std::to_string(times.size()) + " relaxation times",
                   "Give as many of the one as of the other");
}

/// Bulk branches of their own beside the long-term K, which `material` has.
void read_bulk_branches(ParameterSection &section, Material &material)
{
  std::vector<double> moduli, times;
  section.add("Bulk moduli", moduli, Dimensions::pressure,
              "Bulk moduli K_k of the branches that relax, beside the long-term one of Young's "
              "modulus and Poisson's ratio.",
              Range::positive());
  section.add("Bulk relaxation times", times, Dimensions::time,
              "Relaxation times of these branches.", Range::positive());
  section.require("Bulk moduli");
  require_pairs(section, moduli, times, "Bulk relaxation times", "bulk moduli");
  if (material.is_incompressible())
    section.refuse(
        "Volumetric relaxation",
        "an incompressible solid (Poisson's ratio 0.5) has no volume change that relaxes",
        "Give a ratio below 0.5, or Volumetric relaxation = none");
  std::vector<BulkBranch> branches = {BulkBranch{1. / material.inverse_bulk_modulus()}};
  for (std::size_t k = 0; k < moduli.size(); ++k)
    branches.push_back({moduli[k], times[k]});
  material.compression = Compression::relaxing(branches);
}

/// What liquids have besides their viscosity.
void read_liquid(ParameterSection &section, Material &material)
{
  material.compression = read_compression(section);
  section.add("Volume exponent", material.volume_exponent, Dimensions::none,
              "n of the bulk modulus K + n (p - p0), where convection is on: 0 - constant; 1 - the "
              "equation of state of Giannopapa's thesis (2.28); 7.15 - water (Tait).");
  section.add("Reference pressure", material.reference_pressure, Dimensions::pressure,
              "p0, at which Density and Bulk modulus are given, where convection is on.");
}

Material newtonian(ParameterSection &section, const Model model)
{
  refuse_plane_stress(section, model);
  Material material;
  material.density = read_density(section);
  material.shear.viscosity = required_entry(section, "Viscosity", Dimensions::viscosity,
                                            "Dynamic viscosity eta.", Range::not_negative());
  read_liquid(section, material);
  return material;
}

Material carreau_yasuda(ParameterSection &section, const Model model)
{
  refuse_plane_stress(section, model);
  Material material;
  material.density = read_density(section);
  FlowCurve curve;
  curve.zero_rate_viscosity = required_entry(section, "Zero-rate viscosity", Dimensions::viscosity,
                                             "Viscosity at rest, eta_0.", Range::positive());
  curve.infinite_rate_viscosity =
      required_entry(section, "Infinite-rate viscosity", Dimensions::viscosity,
                     "Viscosity at a very high rate of shear, eta_inf.", Range::not_negative());
  curve.time = required_entry(section, "Time constant", Dimensions::time,
                              "lambda; the viscosity begins to change at the rate 1/lambda.",
                              Range::positive());
  curve.index = required_entry(section, "Power-law index", Dimensions::none,
                               "n of eta ~ rate^(n - 1) between both viscosities.",
                               Range{0., 1., true, true});
  section.add("Yasuda exponent", curve.yasuda_exponent, Dimensions::none,
              "a, how sharp the bend at the rate 1/lambda is; 2 is Carreau's law.",
              Range{0.1, 10., true, true});
  if (curve.infinite_rate_viscosity > curve.zero_rate_viscosity)
    section.refuse("Infinite-rate viscosity", "is larger than Zero-rate viscosity",
                   "A liquid of this law becomes thinner: exchange the values");
  material.shear.viscosity = curve.zero_rate_viscosity;
  material.shear.flow_curve = curve;
  read_liquid(section, material);
  return material;
}

Material hookean(ParameterSection &section, const Model model)
{
  Material material;
  material.density = read_density(section);
  const double mu = read_elasticity(section, model, material);
  material.shear.branches = {Branch{mu, std::numeric_limits<double>::infinity()}};
  return material;
}

Material kelvin_voigt(ParameterSection &section, const Model model)
{
  refuse_plane_stress(section, model);
  Material material = hookean(section, model);
  material.shear.viscosity = required_entry(
      section, "Viscosity", Dimensions::viscosity,
      "Viscosity eta of the dash pot beside the spring (stress 2 eta dev sym grad U).",
      Range::not_negative());
  return material;
}

Material maxwell(ParameterSection &section, const Model model)
{
  refuse_plane_stress(section, model);
  Material material;
  material.density = read_density(section);
  material.compression = read_compression(section);
  Branch branch;
  branch.shear_modulus = required_entry(section, "Shear modulus", Dimensions::pressure,
                                        "Shear modulus mu.", Range::positive());
  branch.relaxation_time = required_entry(section, "Relaxation time", Dimensions::time,
                                          "Relaxation time tau.", Range::positive());
  material.shear.branches = {branch};
  const VolumetricRelaxation volume = read_volumetric_relaxation(
      section, false,
      "none - not at all, it is elastic; as the shear - to zero, with the same relaxation time.");
  if (volume == VolumetricRelaxation::as_shear)
  {
    if (material.is_incompressible())
      section.refuse("Volumetric relaxation",
                     "an incompressible solid has no volume change that relaxes",
                     "Give a bulk modulus, or Volumetric relaxation = none");
    material.compression = Compression::relaxing(
        {BulkBranch{1. / material.inverse_bulk_modulus(), branch.relaxation_time}});
  }
  return material;
}

Material prony(ParameterSection &section, const Model model)
{
  refuse_plane_stress(section, model);
  Material material = hookean(section, model);
  std::vector<double> moduli, times;
  section.add("Shear moduli", moduli, Dimensions::pressure,
              "Shear moduli mu_k of the branches that relax.", Range::positive());
  section.add("Relaxation times", times, Dimensions::time,
              "Relaxation times tau_k of these branches.", Range::positive());
  section.require("Shear moduli");
  require_pairs(section, moduli, times, "Relaxation times", "shear moduli");
  for (std::size_t k = 0; k < moduli.size(); ++k)
    material.shear.branches.push_back(Branch{moduli[k], times[k]});
  const VolumetricRelaxation volume = read_volumetric_relaxation(
      section, true,
      "none - not at all, K is elastic, that of Young's modulus and Poisson's ratio; as the shear "
      "- Poisson's ratio is constant, each spring has its share of K; own branches - by branches "
      "of its own.");
  if (volume == VolumetricRelaxation::as_shear)
  {
    const double mu_over_K = material.long_term_shear_modulus() * material.inverse_bulk_modulus();
    relax_volume_as_shear(material, (3. - 2. * mu_over_K) / (6. + 2. * mu_over_K));
  }
  else if (volume == VolumetricRelaxation::own_branches)
    read_bulk_branches(section, material);
  return material;
}

/// c and n: the two numbers, or a table to which they are fitted.
PowerLaw read_relaxation(ParameterSection &section)
{
  double modulus = std::numeric_limits<double>::quiet_NaN(), exponent = modulus;
  section.add(
      "Relaxation modulus at one second", modulus, Dimensions::pressure,
      "c of the relaxation Y(t) = c (t/1 s)^-n of Young's modulus. Required unless there is "
      "a relaxation table.",
      Range::positive());
  section.add("Exponent", exponent, Dimensions::none,
              "n of the relaxation. Required unless there is a relaxation table.",
              Range{0., 1., false, true});
  const RelaxationTest test = read_relaxation_test(section);
  if (test.file.empty())
  {
    section.require("Relaxation modulus at one second");
    section.require("Exponent");
  }
  else
  {
    for (const char *key : {"Relaxation modulus at one second", "Exponent"})
      if (section.given(key))
        section.refuse(key, "the relaxation table gives c and n", "Remove this or the table");
    const RelaxationFit fit = fit_relaxation_test(test);
    modulus = fit.modulus;
    exponent = fit.exponent;
    if (exponent < 0. || exponent >= 1.)
    {
      std::ostringstream text;
      text.precision(3);
      text << "the exponent of the power law through it is " << exponent
           << ", which no solid that relaxes has";
      section.refuse("Relaxation table", text.str(),
                     "The stress must fall with time, slower than 1/t; check columns and units");
    }
  }
  PowerLaw law;
  law.modulus = modulus;
  law.exponent = exponent;
  return law;
}

Material power_law(ParameterSection &section, const Model model)
{
  refuse_plane_stress(section, model);
  Material material;
  material.density = read_density(section);
  PowerLaw law = read_relaxation(section);
  const VolumetricRelaxation volume = read_volumetric_relaxation(
      section, false,
      "none - not at all, K is elastic; as the shear - Poisson's ratio is constant.");
  if (volume == VolumetricRelaxation::as_shear)
    law.poissons_ratio = required_entry(
        section, "Poisson's ratio", Dimensions::none,
        "Poisson's ratio nu, the same at all times and frequencies.", Range{0., 0.5, false, true});
  else
  {
    double bulk_modulus = std::numeric_limits<double>::infinity();
    section.add("Bulk modulus", bulk_modulus, Dimensions::pressure,
                "Bulk modulus K, elastic; left out: incompressible (nu = 0.5).", Range::positive());
    material.compression = Compression::elastic(1. / bulk_modulus);
  }
  law.prony_fit.read(section);
  material.shear.power_law = law;
  return material;
}

/// Share of a spring's modulus that harmonic motion feels: i omega tau / (1 + i omega tau).
std::complex<double> relaxed_part(const std::complex<double> &i_omega, const double relaxation_time)
{
  if (std::isinf(relaxation_time))
    return 1.;
  const std::complex<double> x = i_omega * relaxation_time;
  return x / (1. + x);
}

struct Row
{
  const char *name;
  const char *description;
  Material (*read)(ParameterSection &, Model);
};

const std::vector<Row> &table()
{
  static const std::vector<Row> rows = {
      {"newtonian", "Viscous fluid, compressible by its bulk modulus or incompressible.",
       newtonian},
      {"carreau-yasuda",
       "Liquid whose viscosity falls with the rate of shear, such as blood; with convection.",
       carreau_yasuda},
      {"hookean", "Linear elastic solid.", hookean},
      {"kelvin-voigt", "Elastic solid with a viscosity beside the spring.", kelvin_voigt},
      {"maxwell", "Elastic volume change, shear stress that relaxes to zero.", maxwell},
      {"prony", "Elastic solid with further springs that relax (generalised Maxwell).", prony},
      {"power law",
       "Solid whose modulus relaxes as a power of time; a run takes a Prony series that is fitted "
       "to it.",
       power_law}};
  return rows;
}
} // namespace

std::complex<double> Material::complex_shear_modulus(const std::complex<double> &omega) const
{
  const std::complex<double> i_omega(-omega.imag(), omega.real());
  if (shear.power_law)
  {
    const PowerLaw &law = *shear.power_law;
    const std::complex<double> young = law.young_modulus(i_omega);
    if (law.poissons_ratio)
      return young / (2. * (1. + *law.poissons_ratio));
    return young / (3. - young * inverse_bulk_modulus() / 3.);
  }
  std::complex<double> sum = i_omega * shear.viscosity;
  for (const Branch &branch : shear.branches)
    sum += branch.shear_modulus * relaxed_part(i_omega, branch.relaxation_time);
  return sum;
}

std::complex<double> Material::complex_inverse_bulk_modulus(const std::complex<double> &omega) const
{
  const std::complex<double> i_omega(-omega.imag(), omega.real());
  if (shear.power_law && shear.power_law->poissons_ratio)
    return 3. * (1. - 2. * *shear.power_law->poissons_ratio) /
           shear.power_law->young_modulus(i_omega);
  if (compression.kind() != Compression::Kind::relaxing)
    return inverse_bulk_modulus();
  std::complex<double> sum = 0.;
  for (const BulkBranch &branch : compression.bulk_branches())
    sum += branch.bulk_modulus * relaxed_part(i_omega, branch.relaxation_time);
  return 1. / sum;
}

std::complex<double> Material::complex_young_modulus(const std::complex<double> &omega) const
{
  const std::complex<double> mu = complex_shear_modulus(omega);
  return 9. * mu / (3. + mu * complex_inverse_bulk_modulus(omega));
}

void Material::set_strain_law()
{
  strain_law = make_strain_law(strain_law_parameters, long_term_shear_modulus(),
                               1. / inverse_bulk_modulus());
}

double Material::longitudinal_speed() const
{
  if (is_incompressible())
    return std::numeric_limits<double>::infinity();
  return std::sqrt((1. / inverse_bulk_modulus() + 4. / 3. * instantaneous_shear_modulus()) /
                   density);
}

std::vector<std::pair<std::string, std::string>> material_types()
{
  std::vector<std::pair<std::string, std::string>> types;
  for (const Row &row : table())
    types.emplace_back(row.name, row.description);
  return types;
}

Material read_material(ParameterSection section, const Model model)
{
  std::vector<std::string> names;
  std::string text = "The constitutive law; required.";
  for (const Row &row : table())
  {
    names.emplace_back(row.name);
    text += std::string(" ") + row.name + " - " + row.description;
  }
  std::string type = "hookean";
  section.add_choice("Type", type, names, text);
  section.require("Type");
  // A table names what is missing otherwise.
  if (type != "power law" && section.given("Relaxation table"))
    section.refuse("Relaxation table",
                   "a material '" + type + "' does not take its constants from a table",
                   "Fit the table with 'Analysis = material fit', and write the entries of its "
                   "material.prm here; only 'Type = power law' is fitted to a table here");
  for (const Row &row : table())
    if (type == row.name)
    {
      Material material = row.read(section, model);
      material.type = type;
      return material;
    }
  section.refuse("Type", "unknown law '" + type + "'", "Choose one of the laws of the manual");
}

void read_strain_law(ParameterSection section, Material &material)
{
  if (!material.is_solid())
    return;
  material.strain_law_parameters.read(section, material.is_incompressible());
  material.prestretch.read(section);
  material.set_strain_law();
}
} // namespace Continua
