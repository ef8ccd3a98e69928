// Tests of a body of one strain: closed forms of incompressible rubber, the linear moduli at rest
// of compressible solids, stress and slope against differences of energy and stress, and strips
// with fibres.

#include <continua/laboratory/homogeneous_test.h>

#include <continua/base/input_error.h>
#include <continua/materials/strain_law_types.h>

#include <cmath>

#include "../unit_test.h"

namespace test_of_homogeneous_test
{
using namespace Continua;

namespace
{
constexpr double spring = 1.3e6; // mu [Pa]

std::unique_ptr<StrainLaw> law_of(const std::string &type, const double bulk_modulus = 4e6)
{
  StrainLawParameters parameters;
  parameters.type = type;
  parameters.mooney_rivlin_share = 0.3;
  parameters.fibre_stiffness = 0.8e6;
  parameters.fibre_exponent = 1.5;
  parameters.fibre_dispersion = 0.1;
  return make_strain_law(parameters, spring, bulk_modulus);
}

double nominal(const HomogeneousTest &test, const HomogeneousTestType type, const double measure)
{
  return test.at(type, measure).nominal_stress;
}

void check_rubber()
{
  const double l = 1.8, gamma = 0.7, mu1 = 0.7 * spring, mu2 = 0.3 * spring;
  const auto neo = law_of("neo hookean"), mooney = law_of("mooney rivlin");
  const HomogeneousTest a(*neo, 0., {}), b(*mooney, 0., {});
  using Type = HomogeneousTestType;
  check::relative("neo hookean: uniaxial", nominal(a, Type::uniaxial, l),
                  spring * (l - std::pow(l, -2)), 1e-12);
  check::relative("neo hookean: compressed", nominal(a, Type::uniaxial, 0.4),
                  spring * (0.4 - std::pow(0.4, -2)), 1e-12);
  check::relative("neo hookean: Cauchy stress", a.at(Type::uniaxial, l).cauchy_stress,
                  spring * (l * l - 1. / l), 1e-12);
  check::relative("neo hookean: equibiaxial", nominal(a, Type::equibiaxial, l),
                  spring * (l - std::pow(l, -5)), 1e-12);
  check::relative("neo hookean: planar", nominal(a, Type::planar, l),
                  spring * (l - std::pow(l, -3)), 1e-12);
  check::relative("neo hookean: shear", nominal(a, Type::shear, gamma), spring * gamma, 1e-12);
  check::relative("neo hookean: normal stresses of shear",
                  a.at(Type::shear, gamma).normal_difference, spring * gamma * gamma, 1e-12);
  check::relative("neo hookean: slope of shear", a.at(Type::shear, gamma).tangent_modulus, spring,
                  1e-12);
  check::relative("mooney rivlin: uniaxial", nominal(b, Type::uniaxial, l),
                  (mu1 + mu2 / l) * (l - std::pow(l, -2)), 1e-12);
  check::relative("mooney rivlin: equibiaxial", nominal(b, Type::equibiaxial, l),
                  (mu1 + mu2 * l * l) * (l - std::pow(l, -5)), 1e-12);
  check::relative("mooney rivlin: planar", nominal(b, Type::planar, l),
                  spring * (l - std::pow(l, -3)), 1e-12);
  check::relative("mooney rivlin: shear", nominal(b, Type::shear, gamma), spring * gamma, 1e-12);
}

/// Of the linear theory.
void check_moduli_at_rest()
{
  for (const std::string type : {"neo hookean", "mooney rivlin", "st venant kirchhoff"})
    for (const double k : {3e6, 1e9})
    {
      const auto law = law_of(type, k);
      const HomogeneousTest test(*law, 1. / k, {});
      const double young = 9. * k * spring / (3. * k + spring),
                   nu = (3. * k - 2. * spring) / (6. * k + 2. * spring);
      using Type = HomogeneousTestType;
      check::relative(type + " at rest: uniaxial", test.at(Type::uniaxial, 1.).tangent_modulus,
                      young, 1e-9);
      check::relative(type + " at rest: equibiaxial",
                      test.at(Type::equibiaxial, 1.).tangent_modulus, young / (1. - nu), 1e-9);
      check::relative(type + " at rest: planar", test.at(Type::planar, 1.).tangent_modulus,
                      young / (1. - nu * nu), 1e-9);
      check::relative(type + " at rest: shear", test.at(Type::shear, 0.).tangent_modulus, spring,
                      1e-9);
    }
  // The second Piola-Kirchhoff stress of a bar is Young's modulus times Green's strain.
  const double l = 1.6, k = 3e6;
  const auto law = law_of("st venant kirchhoff", k);
  check::relative("st venant kirchhoff: a bar",
                  nominal(HomogeneousTest(*law, 1. / k, {}), HomogeneousTestType::uniaxial, l),
                  9. * k * spring / (3. * k + spring) * l * 0.5 * (l * l - 1.), 1e-12);
}

/// The work of the loads is the energy: of the law, and p^2/(2 K) J of ln J = -p/K.
void check_slopes()
{
  StrainLawParameters with_fibres;
  with_fibres.type = "holzapfel gasser ogden";
  with_fibres.fibre_angle = 0.5;
  const auto fibres =
      with_fibres.fibres(dealii::Tensor<1, 3>({1., 0., 0.}), dealii::Tensor<1, 3>({0., 1., 0.}));
  for (const StrainLawType &row : strain_law_types())
  {
    const auto law = law_of(row.name);
    const HomogeneousTest test(*law, row.needs_bulk_modulus ? 1. / 4e6 : 0., fibres);
    for (const auto &[word, type] : homogeneous_test_words())
    {
      const double measure = type == HomogeneousTestType::shear ? 0.4 : 1.3, h = 1e-3;
      const auto slope = [&](const auto &value)
      {
        return (8. * (value(measure + h) - value(measure - h)) -
                (value(measure + 2. * h) - value(measure - 2. * h))) /
               (12. * h);
      };
      const HomogeneousTestPoint point = test.at(type, measure);
      const double n_loads = type == HomogeneousTestType::equibiaxial ? 2. : 1.;
      const double stresses = slope([&](const double x) { return test.at(type, x).energy; });
      // With fibres both directions of an equibiaxial test have stresses of their own.
      if (n_loads == 1. || !row.has_fibres)
        check::relative(row.name + ", " + word + ": energy", stresses,
                        n_loads * point.nominal_stress, 1e-7);
      check::relative(row.name + ", " + word + ": slope",
                      slope([&](const double x) { return nominal(test, type, x); }),
                      point.tangent_modulus, 1e-7);
    }
  }
  const auto law = law_of("holzapfel gasser ogden");
  const HomogeneousTestPoint strip =
      HomogeneousTest(*law, 0., fibres).at(HomogeneousTestType::uniaxial, 1.3);
  dealii::SymmetricTensor<2, 3> stress;
  law->set_stress(strip.strain, stress);
  check::absolute("a strip with fibres: sides alike", (stress[1][1] - stress[2][2]) / spring, 0.,
                  1e-12);
  check::relative("a strip with fibres: volume", strip.volume_ratio, 1., 1e-13);
  check::is_true("a strip with fibres: narrower than thick",
                 strip.strain.gradient[1][1] < strip.strain.gradient[2][2] - 0.01);
}
} // namespace

UNIT_TEST(homogeneous_test)
{
  check_rubber();
  check_moduli_at_rest();
  check_slopes();
  const double k = 3e6;
  const auto law = law_of("neo hookean");
  const HomogeneousTestPoint point =
      HomogeneousTest(*law, 1. / k, {}).at(HomogeneousTestType::uniaxial, 1.5);
  // A bar's pressure is minus a third of its stress.
  check::relative("the volume follows the pressure", std::log(point.volume_ratio),
                  point.cauchy_stress / (3. * k), 1e-10);
  const auto artery = law_of("holzapfel gasser ogden");
  const HomogeneousTest stiff(*artery, 0., {dealii::Tensor<1, 3>({1., 0., 0.})});
  check::throws<RunError>(
      "a stress beyond all numbers", [&] { stiff.at(HomogeneousTestType::uniaxial, 40.); },
      "no equilibrium.*40");
}
} // namespace test_of_homogeneous_test
