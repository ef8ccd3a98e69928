// Constants of laws from curves: those that made the curve, and the line of least squares where the
// law cannot follow.

#include <continua/laboratory/strain_law_fit.h>

#include <continua/base/input_error.h>
#include <continua/materials/strain_law_types.h>

#include <algorithm>
#include <cmath>

#include "../unit_test.h"

namespace test_of_strain_law_fit
{
using namespace Continua;

namespace
{
StretchTable curve_of(const StrainLawParameters &parameters,
                      const double shear_modulus,
                      const double inverse_bulk_modulus,
                      const HomogeneousTestType type,
                      const CuttingDirection direction = CuttingDirection::axial)
{
  const auto law = make_strain_law(parameters, shear_modulus, 1. / inverse_bulk_modulus);
  const HomogeneousTest specimen(*law, inverse_bulk_modulus,
                                 fibres_of_specimen(parameters, direction));
  StretchTable table;
  table.type = type;
  for (unsigned int i = 1; i <= 12; ++i)
  {
    table.strain_measures.push_back(1. + 0.05 * i);
    table.stresses.push_back(specimen.at(type, table.strain_measures.back()).nominal_stress);
  }
  return table;
}
} // namespace

UNIT_TEST(strain_law_fit)
{
  using Type = HomogeneousTestType;
  const CuttingDirection along = CuttingDirection::axial;
  StrainLawParameters neo, mooney, artery;
  mooney.type = "mooney rivlin";
  artery.type = "holzapfel gasser ogden";
  artery.fibre_angle = 0.6;
  artery.fibre_dispersion = 0.05;
  {
    const StrainLawFit fit =
        fit_strain_law(neo, 2e5, 0., along, {curve_of(neo, 7e5, 0., Type::planar)});
    check::relative("neo hookean: shear modulus", fit.shear_modulus, 7e5, 1e-9);
    check::absolute("neo hookean: misfit", fit.misfit, 0., 1e-9);
  }
  {
    StrainLawParameters exact = mooney;
    exact.mooney_rivlin_share = 0.2;
    const std::vector<StretchTable> tables = {curve_of(exact, 7e5, 1e-7, Type::uniaxial),
                                              curve_of(exact, 7e5, 1e-7, Type::equibiaxial),
                                              curve_of(exact, 7e5, 1e-7, Type::shear)};
    // Three times the shear modulus, and of the bulk modulus.
    const StrainLawFit fit = fit_strain_law(mooney, 21e5, 1e-7 / 3., along, tables);
    check::relative("mooney rivlin: shear modulus", fit.shear_modulus, 7e5, 1e-7);
    check::relative("mooney rivlin: share", fit.parameters.mooney_rivlin_share, 0.2, 1e-6);
    check::absolute("mooney rivlin: misfit", fit.misfit, 0., 1e-8);
    // Neo-Hookean is linear in mu: the weighted line of least squares through rows with their
    // largest as unit.
    const StretchTable &table = tables[0];
    double product = 0., square = 0., difference = 0.;
    const StretchTable unit = curve_of(neo, 1., 1e-7 * 7e5, Type::uniaxial);
    for (std::size_t row = 0; row < table.strain_measures.size(); ++row)
    {
      product += unit.stresses[row] * table.stresses[row];
      square += unit.stresses[row] * unit.stresses[row];
    }
    const double largest = *std::max_element(table.stresses.begin(), table.stresses.end());
    for (std::size_t row = 0; row < table.strain_measures.size(); ++row)
      difference +=
          std::pow((product / square * unit.stresses[row] - table.stresses[row]) / largest, 2);
    const StrainLawFit line = fit_strain_law(neo, 7e5, 1e-7, along, {table});
    check::relative("a law that cannot follow: shear modulus", line.shear_modulus, product / square,
                    1e-7);
    check::relative("a law that cannot follow: misfit", line.misfit,
                    std::sqrt(difference / table.strain_measures.size()), 1e-6);
  }
  for (const CuttingDirection direction :
       {CuttingDirection::axial, CuttingDirection::circumferential})
  {
    StrainLawParameters exact = artery;
    exact.fibre_stiffness = 2e4;
    exact.fibre_exponent = 0.7;
    const StrainLawFit fit = fit_strain_law(artery, 5e4, 0., direction,
                                            {curve_of(exact, 3e4, 0., Type::uniaxial, direction)});
    check::relative("holzapfel gasser ogden: shear modulus", fit.shear_modulus, 3e4, 1e-5);
    check::relative("holzapfel gasser ogden: stiffness", fit.parameters.fibre_stiffness, 2e4, 1e-5);
    check::relative("holzapfel gasser ogden: exponent", fit.parameters.fibre_exponent, 0.7, 1e-5);
    check::absolute("holzapfel gasser ogden: angle stays", fit.parameters.fibre_angle, 0.6, 0.);
  }
  // The fibres lie closer to the axis.
  check::relative("an axial strip: along its fibres", fibres_of_specimen(artery, along)[0][0],
                  std::cos(0.6), 1e-15);
  check::relative("a circumferential strip: across its fibres",
                  fibres_of_specimen(artery, CuttingDirection::circumferential)[0][0],
                  std::sin(0.6), 1e-15);
  StrainLawParameters stiff = artery;
  stiff.fibre_stiffness = 1e5;
  stiff.fibre_exponent = 1e6;
  check::throws<RunError>(
      "no start",
      [&] { fit_strain_law(stiff, 1e5, 0., along, {curve_of(neo, 1e5, 0., Type::uniaxial)}); },
      "cannot begin");
}
} // namespace test_of_strain_law_fit
