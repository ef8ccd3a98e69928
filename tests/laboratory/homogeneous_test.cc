// Tests of a body of one strain: closed forms of incompressible rubber, the linear moduli at zero
// strain of compressible solids, stress and slope against differences of energy and stress, and
// strips with fibres.

#include <continua/laboratory/homogeneous_test.h>

#include <continua/base/input_error.h>
#include <continua/materials/strain_law_types.h>

#include <algorithm>
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

double
nominal(const HomogeneousTest &test, const HomogeneousTestType type, const double strain_measure)
{
  return test.at(type, strain_measure).nominal_stress;
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
void check_moduli_at_no_strain()
{
  for (const std::string type : {"neo hookean", "mooney rivlin", "st venant kirchhoff"})
    for (const double k : {3e6, 1e9})
    {
      const auto law = law_of(type, k);
      const HomogeneousTest test(*law, 1. / k, {});
      const double young = 9. * k * spring / (3. * k + spring),
                   nu = (3. * k - 2. * spring) / (6. * k + 2. * spring);
      using Type = HomogeneousTestType;
      check::relative(type + " at no strain: uniaxial", test.at(Type::uniaxial, 1.).tangent_modulus,
                      young, 1e-9);
      check::relative(type + " at no strain: equibiaxial",
                      test.at(Type::equibiaxial, 1.).tangent_modulus, young / (1. - nu), 1e-9);
      check::relative(type + " at no strain: planar", test.at(Type::planar, 1.).tangent_modulus,
                      young / (1. - nu * nu), 1e-9);
      check::relative(type + " at no strain: shear", test.at(Type::shear, 0.).tangent_modulus,
                      spring, 1e-9);
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
      const double strain_measure = type == HomogeneousTestType::shear ? 0.4 : 1.3, h = 1e-3;
      const auto slope = [&](const auto &value)
      {
        return (8. * (value(strain_measure + h) - value(strain_measure - h)) -
                (value(strain_measure + 2. * h) - value(strain_measure - 2. * h))) /
               (12. * h);
      };
      const HomogeneousTestPoint point = test.at(type, strain_measure);
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
/// St. Venant-Kirchhoff's law bears what the stretches demand: without stress across, Green's
/// strain there is -q times that along, so that this side is gone at the stretch sqrt(1 + 1/q).
void check_ends_of_saint_venant_kirchhoff()
{
  using Type = HomogeneousTestType;
  for (const double nu : {-0.3, 0., 0.2, 0.3, 0.49})
  {
    const double k = 2. * spring * (1. + nu) / (3. * (1. - 2. * nu)),
                 young = 2. * spring * (1. + nu);
    const auto law = law_of("st venant kirchhoff", k);
    const HomogeneousTest test(*law, 1. / k, {});
    struct Side
    {
      Type type;
      std::string name;
      double across, modulus; // of Green's strains; S = modulus times Green's strain
    };
    for (const Side &side :
         {Side{Type::uniaxial, "uniaxial", nu, young},
          Side{Type::equibiaxial, "equibiaxial", 2. * nu / (1. - nu), young / (1. - nu)},
          Side{Type::planar, "planar", nu / (1. - nu), young / (1. - nu * nu)}})
    {
      const std::string name = side.name + ", Poisson's ratio " + std::to_string(nu).substr(0, 4);
      const double tension =
          side.across > 0. ? std::min(100., std::sqrt(1. + 1. / side.across)) : 100.;
      // A negative ratio makes the sides shrink under compression.
      const double compression =
          side.across < -1. ? std::max(0.01, std::sqrt(1. + 1. / side.across)) : 0.01;
      check::relative(name + ": end in tension", test.end(side.type, 100.).strain_measure, tension,
                      1e-7);
      check::relative(name + ": end in compression", test.end(side.type, 0.01).strain_measure,
                      compression, 1e-7);
      double largest = 0., of_slope = 0.;
      for (const double part : {-0.999, -0.9, -0.6, -0.2, 0.2, 0.5, 0.9, 0.999})
      {
        const double l = std::pow(part < 0. ? compression : tension, std::abs(part)),
                     exact = side.modulus * l * 0.5 * (l * l - 1.),
                     slope = side.modulus * 0.5 * (3. * l * l - 1.);
        const HomogeneousTestPoint point = test.at(side.type, l);
        largest = std::max(largest, std::abs(point.nominal_stress / exact - 1.));
        of_slope = std::max(of_slope, std::abs(point.tangent_modulus / slope - 1.));
      }
      check::absolute(name + ": stress to the ends", largest, 0., 1e-9);
      check::absolute(name + ": slope to the ends", of_slope, 0., 1e-9);
    }
  }
  const auto law = law_of("st venant kirchhoff", 2. * spring * 1.3 / 1.2);
  const HomogeneousTest test(*law, 1.2 / (2. * spring * 1.3), {});
  check::throws<RunError>(
      "the sides are gone", [&] { test.at(Type::uniaxial, 2.5); },
      "at the stretch 2.5: the law has none beyond 2\\.08167\\. There the free sides shrink to "
      "nothing");
  // Poisson's ratio 0.3. Near the end the stress depends on the square of the sides' stretch, which
  // round-off hides below 1e-8.
  for (const double asked : {2.1, 90.})
    check::relative(asked < 3. ? "the place, 2.1 asked for" : "the place, 90 asked for",
                    test.end(Type::uniaxial, asked).strain_measure, std::sqrt(1. + 1. / 0.3), 1e-7);
}

/// A rubber that follows ln J = -p/K and is compressed: without stress across, the volume and the
/// stretch are bound by mu J^(-5/3) (2 c - a - b)/3 = -K ln J (a, b, c: squares of the stretches, c
/// across the thickness). Over the volume this stretch has a least value: the end.
void check_ends_of_neo_hookean()
{
  using Type = HomogeneousTestType;
  const double k = 3. * spring;
  const auto law = law_of("neo hookean", k);
  const HomogeneousTest test(*law, 1. / k, {});
  for (const auto &[word, type] : homogeneous_test_words())
  {
    if (type == Type::shear)
      continue;
    const auto balance = [type = type, k](const double l, const double volume)
    {
      // Squares of the stretches along, along the second direction and across the thickness.
      const double first = l * l,
                   second = type == Type::uniaxial      ? volume / l
                            : type == Type::equibiaxial ? first
                                                        : 1.,
                   third = type == Type::uniaxial ? second : volume * volume / (first * second);
      return spring * std::pow(volume, -5. / 3.) * (2. * third - first - second) / 3. +
             k * std::log(volume);
    };
    double least = 1.;
    for (double logarithm = -3.; logarithm < -0.01; logarithm += 1e-3)
    {
      // For this volume, the stretch between which and a smaller one the balance changes its sign.
      const double volume = std::exp(logarithm);
      double below = 1e-3, above = std::min(1., std::pow(volume, type == Type::planar ? 1. : 0.5));
      if (balance(above, volume) > 0.)
        continue;
      while (above - below > 1e-10)
      {
        const double middle = 0.5 * (below + above);
        (balance(middle, volume) > 0. ? below : above) = middle;
      }
      least = std::min(least, above);
    }
    check::relative("neo hookean, " + word + ": end in compression",
                    test.end(type, 0.01).strain_measure, least, 1e-6);
    check::is_true("neo hookean, " + word + ": the sides lose their stability",
                   test.end(type, 0.01).reason.find("limit point") != std::string::npos);
    check::relative("neo hookean, " + word + ": no end in tension",
                    test.end(type, 100.).strain_measure, 100., 0.);
  }
}

/// Laws whose volume stays bear every stretch, as far as there are numbers.
void check_wide_ranges()
{
  using Type = HomogeneousTestType;
  const double mu1 = 0.7 * spring, mu2 = 0.3 * spring, k1 = 0.8e6, k2 = 1.5;
  const auto mooney = law_of("mooney rivlin");
  const HomogeneousTest rubber(*mooney, 0., {});
  double largest = 0.;
  for (const double l : {0.03, 0.1, 0.2, 5., 30., 100.})
  {
    const auto take = [&](const Type type, const double exact)
    { largest = std::max(largest, std::abs(nominal(rubber, type, l) / exact - 1.)); };
    take(Type::uniaxial, (mu1 + mu2 / l) * (l - std::pow(l, -2)));
    take(Type::equibiaxial, (mu1 + mu2 * l * l) * (l - std::pow(l, -5)));
    take(Type::planar, spring * (l - std::pow(l, -3)));
  }
  check::absolute("mooney rivlin from 0.03 to 100", largest, 0., 1e-9);

  StrainLawParameters parameters;
  parameters.type = "holzapfel gasser ogden";
  parameters.fibre_stiffness = k1;
  parameters.fibre_exponent = k2;
  const auto artery = make_strain_law(parameters, spring, 1e9);
  const HomogeneousTest strip(*artery, 0., {dealii::Tensor<1, 3>({1., 0., 0.})});
  double of_fibres = 0.;
  for (const double l : {0.01, 0.5, 1.2, 1.8, 2.1, 2.3})
  {
    const double e = std::max(0., l * l - 1.);
    const double exact = spring * (l - std::pow(l, -2)) + 2. * k1 * e * l * std::exp(k2 * e * e);
    of_fibres = std::max(of_fibres, std::abs(nominal(strip, Type::uniaxial, l) / exact - 1.));
  }
  check::absolute("fibres along the axis", of_fibres, 0., 1e-9);
  check::throws<RunError>(
      "stiff fibres in a soft matrix", [&] { strip.at(Type::uniaxial, 40.); },
      "no equilibrium at the stretch 40.*times the shear modulus");
  check::throws<RunError>(
      "a shear beyond all numbers", [&] { strip.at(Type::shear, 1e200); }, "larger than a number");
}
} // namespace

UNIT_TEST(homogeneous_test)
{
  check_ends_of_saint_venant_kirchhoff();
  check_ends_of_neo_hookean();
  check_wide_ranges();
  check_rubber();
  check_moduli_at_no_strain();
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
      "no equilibrium at the stretch 40.*larger than a number can hold");
}
} // namespace test_of_homogeneous_test
