#include <continua/materials/strain_law_types.h>

#include <continua/base/angle_entry.h>
#include <continua/base/required_entry.h>
#include <continua/materials/holzapfel_gasser_ogden.h>
#include <continua/materials/mooney_rivlin.h>
#include <continua/materials/neo_hookean.h>
#include <continua/materials/saint_venant_kirchhoff.h>

#include <stdexcept>

namespace Continua
{
namespace
{
void read_no_entries(ParameterSection &, StrainLawParameters &) {}

void read_mooney_rivlin(ParameterSection &section, StrainLawParameters &parameters)
{
  parameters.mooney_rivlin_share =
      required_entry(section, "Mooney-Rivlin share", Dimensions::none,
                     "mu2/(mu1 + mu2), the share of the second invariant in the shear modulus; 0 "
                     "is neo-Hookean.",
                     Range{0., 1.});
}

void read_fibres(ParameterSection &section, StrainLawParameters &parameters)
{
  parameters.fibre_stiffness =
      required_entry(section, "Fibre stiffness", Dimensions::pressure,
                     "k1 of the energy k1/(2 k2) (exp(k2 E^2) - 1) of each of both families of "
                     "fibres.",
                     Range::not_negative());
  parameters.fibre_exponent = required_entry(
      section, "Fibre exponent", Dimensions::none,
      "k2 of it: how fast fibres stiffen with their strain E.", Range::not_negative());
  section.add("Fibre dispersion", parameters.fibre_dispersion, Dimensions::none,
              "kappa, how far the directions of a family differ: 0 - not at all; 1/3 - all "
              "directions are alike.",
              Range{0., 1. / 3.});
  add_angle(section, "Fibre angle", parameters.fibre_angle,
            "Angle of the fibres from the axis, in the stress-free state: one family at plus, one "
            "at minus this angle towards the circumference. Required.");
  section.require("Fibre angle");
}

std::unique_ptr<StrainLaw>
make_neo_hookean(const StrainLawParameters &, const double shear_modulus, const double)
{
  return std::make_unique<NeoHookean>(shear_modulus);
}

std::unique_ptr<StrainLaw>
make_mooney_rivlin(const StrainLawParameters &parameters, const double shear_modulus, const double)
{
  const double second = parameters.mooney_rivlin_share * shear_modulus;
  return std::make_unique<MooneyRivlin>(shear_modulus - second, second);
}

std::unique_ptr<StrainLaw> make_saint_venant_kirchhoff(const StrainLawParameters &,
                                                       const double shear_modulus,
                                                       const double bulk_modulus)
{
  return std::make_unique<SaintVenantKirchhoff>(shear_modulus,
                                                bulk_modulus - 2. / 3. * shear_modulus);
}

std::unique_ptr<StrainLaw> make_holzapfel_gasser_ogden(const StrainLawParameters &parameters,
                                                       const double shear_modulus,
                                                       const double)
{
  return std::make_unique<HolzapfelGasserOgden>(shear_modulus, parameters.fibre_stiffness,
                                                parameters.fibre_exponent,
                                                parameters.fibre_dispersion);
}
} // namespace

const std::vector<StrainLawType> &strain_law_types()
{
  static const std::vector<StrainLawType> rows = {
      {"neo hookean",
       "Rubber at moderate strains: energy by the first invariant.",
       false,
       false,
       {},
       read_no_entries,
       make_neo_hookean},
      {"mooney rivlin",
       "Rubber: energy by both invariants.",
       false,
       false,
       {{"Mooney-Rivlin share", Dimensions::none, &StrainLawParameters::mooney_rivlin_share, true,
         0.5}},
       read_mooney_rivlin,
       make_mooney_rivlin},
      {"st venant kirchhoff",
       "Large rotations and small strains: linear in Green's strain, the pressure included.",
       false,
       true,
       {},
       read_no_entries,
       make_saint_venant_kirchhoff},
      {"holzapfel gasser ogden",
       "Wall of an artery: neo-Hookean with two families of fibres that stiffen.",
       true,
       false,
       {{"Fibre stiffness", Dimensions::pressure, &StrainLawParameters::fibre_stiffness, false,
         1e3},
        {"Fibre exponent", Dimensions::none, &StrainLawParameters::fibre_exponent, false, 1.}},
       read_fibres,
       make_holzapfel_gasser_ogden}};
  return rows;
}

const StrainLawType &strain_law_type(const std::string &name)
{
  for (const StrainLawType &row : strain_law_types())
    if (row.name == name)
      return row;
  throw std::logic_error("there is no strain law '" + name + "'");
}

std::unique_ptr<StrainLaw> make_strain_law(const StrainLawParameters &parameters,
                                           const double shear_modulus,
                                           const double bulk_modulus)
{
  return strain_law_type(parameters.type).make(parameters, shear_modulus, bulk_modulus);
}
} // namespace Continua
