// The entries of the hyperelastic laws, the laws that they make, and what is refused.

#include <continua/materials/strain_law_parameters.h>
#include <continua/materials/strain_law_types.h>

#include <cmath>
#include <limits>

#include "../parameter_text.h"
#include "../unit_test.h"

namespace test_of_strain_law_parameters
{
using namespace Continua;

namespace
{
StrainLawParameters parameters_of_law(const std::string &entries, const bool incompressible = true)
{
  ParameterFile file = parameters_of("subsection wall\n" + entries + "end\n");
  ParameterSection section = file.root().subsection("wall");
  StrainLawParameters parameters;
  parameters.read(section, incompressible);
  file.refuse_unknown();
  return parameters;
}

void refused_law(const std::string &name, const std::string &entries, const std::string &pattern)
{
  check::throws<InputError>(
      name, [&] { parameters_of_law(entries); }, pattern);
}
} // namespace

UNIT_TEST(strain_law_parameters)
{
  const double infinite = std::numeric_limits<double>::infinity();
  check::equal("default", parameters_of_law("").type, "neo hookean");
  check::is_true("no fibres by default", !parameters_of_law("").has_fibres());
  check::relative("neo hookean: shear modulus",
                  make_strain_law(parameters_of_law(""), 2., infinite)->shear_modulus(), 2., 0.);
  const StrainLawParameters mooney =
      parameters_of_law("set Strain law = mooney rivlin\nset Mooney-Rivlin share = 25 %\n");
  check::relative("mooney rivlin: share", mooney.mooney_rivlin_share, 0.25, 1e-15);
  check::relative("mooney rivlin: shear modulus",
                  make_strain_law(mooney, 2., infinite)->shear_modulus(), 2., 1e-15);
  check::is_true(
      "st venant kirchhoff: a compressible solid",
      make_strain_law(parameters_of_law("set Strain law = st venant kirchhoff\n", false), 2., 5.)
          ->has_own_mean_stress());

  const std::string fibres =
      "set Strain law = holzapfel gasser ogden\nset Fibre stiffness = 2 kPa\n"
      "set Fibre exponent = 1.5\n";
  const StrainLawParameters artery =
      parameters_of_law(fibres + "set Fibre angle = 30 deg\nset Fibre dispersion = 0.2\n");
  check::relative("k1", artery.fibre_stiffness, 2e3, 1e-15);
  check::relative("k2", artery.fibre_exponent, 1.5, 0.);
  check::relative("kappa", artery.fibre_dispersion, 0.2, 0.);
  const auto directions =
      artery.fibres(dealii::Tensor<1, 3>({1., 0., 0.}), dealii::Tensor<1, 3>({0., 0., 1.}));
  check::is_true("two families", directions.size() == 2);
  check::relative("from the axis", directions[0][0], std::sqrt(0.75), 1e-15);
  check::relative("towards the circumference", directions[0][2], 0.5, 1e-15);
  check::relative("the other one: from the axis", directions[1][0], std::sqrt(0.75), 1e-15);
  check::relative("the other one: away from it", directions[1][2], -0.5, 1e-15);

  refused_law("unknown law", "set Strain law = ogden\n",
              ":2: 'wall/Strain law'.*ogden.*neo hookean");
  refused_law("incompressible", "set Strain law = st venant kirchhoff\n",
              ":2: 'wall/Strain law'.*no incompressible form.*below 0.5");
  refused_law("no share", "set Strain law = mooney rivlin\n", "'Mooney-Rivlin share' is missing");
  refused_law("share above 1", "set Strain law = mooney rivlin\nset Mooney-Rivlin share = 1.1\n",
              ":3: 'wall/Mooney-Rivlin share'.*1");
  refused_law("entry of another law", "set Mooney-Rivlin share = 0.1\n", ":2.*Mooney-Rivlin share");
  refused_law("no angle", fibres, "'Fibre angle' is missing");
  refused_law("angle without unit", fibres + "set Fibre angle = 30\n",
              ":5: 'wall/Fibre angle'.*no unit.*deg");
  refused_law("dispersion above a third",
              fibres + "set Fibre angle = 30 deg\nset Fibre dispersion = 0.34\n",
              ":6: 'wall/Fibre dispersion'.*0.34");
  refused_law("stiffness negative",
              "set Strain law = holzapfel gasser ogden\nset Fibre stiffness = -1 kPa\n",
              ":3: 'wall/Fibre stiffness'");
}
} // namespace test_of_strain_law_parameters
