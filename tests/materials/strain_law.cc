// Every hyperelastic law of the table: stress against differences of its energy, tangent against
// differences of its stress, objectivity, the limit of small strains; and closed forms.

#include <continua/materials/strain_law_types.h>

#include <algorithm>
#include <stdexcept>

#include "../unit_test.h"
#include "strain_at_point.h"

namespace test_of_strain_law
{
using namespace Continua;
using namespace strain_at_point;
using dealii::SymmetricTensor;

namespace
{
constexpr double mu = 1.3, bulk_modulus = 4.;

StrainLawParameters some_law(const std::string &type)
{
  StrainLawParameters parameters;
  parameters.type = type;
  parameters.mooney_rivlin_share = 0.3;
  parameters.fibre_stiffness = 0.8;
  parameters.fibre_exponent = 1.5;
  parameters.fibre_dispersion = 0.1;
  parameters.fibre_angle = 0.6;
  return parameters;
}

Symmetric2 stress_of(const StrainLaw &law, const PointStrain &strain)
{
  Symmetric2 stress, alone, slope;
  law.set_stress(strain, stress);
  if (!law.has_own_mean_stress())
    return stress;
  // Together with the mean it is the same.
  double mean;
  alone = stress;
  law.set_stresses(strain, stress, mean, slope);
  return 0.5 * (alone + stress);
}

/// J s, of laws that have it.
double mean_kirchhoff_stress(const StrainLaw &law, const PointStrain &strain)
{
  if (!law.has_own_mean_stress())
    return 0.;
  double mean;
  Symmetric2 slope;
  Symmetric2 stress;
  law.set_stresses(strain, stress, mean, slope);
  return strain.determinant * mean;
}

void check_derivatives(const StrainLawType &type, const StrainLaw &law)
{
  std::mt19937 random(11);
  const auto fibres =
      some_law(type.name).fibres(dealii::Tensor<1, 3>({1. / 3., 2. / 3., 2. / 3.}),
                                 dealii::Tensor<1, 3>({2. / 3., 1. / 3., -2. / 3.}));
  double of_energy = 0., of_stress = 0., of_mean = 0., of_trace = 0., of_both = 0.;
  double of_rotation = 0., of_rotated_energy = 0.;
  for (unsigned int trial = 0; trial < 20; ++trial)
  {
    const Tensor2 f = unit_tensor() + random_tensor(random, 0.3), g = random_tensor(random, 1.);
    const PointStrain strain = strain_of(f, fibres);
    const auto moved = [&](const double h) { return strain_of(f + h * g * f, fibres); };
    Symmetric2 stress;
    SymmetricTensor<4, 3> tangent;
    law.set_tangent(strain, stress, tangent);
    const double scale = stress.norm();
    of_trace = std::max(of_trace, std::abs(trace(stress)) / scale);
    of_both = std::max(of_both, (stress - stress_of(law, strain)).norm() / scale);

    const double power = stress * symmetrize(g) + mean_kirchhoff_stress(law, strain) * trace(g);
    const double energy_rate =
        derivative<double>([&](const double h) { return law.energy(moved(h)); });
    of_energy = std::max(of_energy, std::abs(power - energy_rate) / scale);

    const Symmetric2 stress_rate =
        derivative<Symmetric2>([&](const double h) { return stress_of(law, moved(h)); });
    of_stress = std::max(of_stress,
                         (stress_change(tangent, stress, g) - stress_rate).norm() / tangent.norm());
    if (law.has_own_mean_stress())
    {
      double mean;
      Symmetric2 slope;
      law.set_mean_stress(strain, mean, slope);
      const double mean_rate = derivative<double>(
          [&](const double h)
          { return mean_kirchhoff_stress(law, moved(h)) / moved(h).determinant; });
      of_mean = std::max(of_mean, std::abs(slope * symmetrize(g) - mean_rate) / slope.norm());
    }

    const Tensor2 q = random_rotation(random);
    const PointStrain rotated = strain_of(q * f, fibres);
    of_rotation =
        std::max(of_rotation,
                 (stress_of(law, rotated) - symmetrize(q * stress * transpose(q))).norm() / scale);
    of_rotated_energy =
        std::max(of_rotated_energy, std::abs(law.energy(rotated) / law.energy(strain) - 1.));
  }
  check::absolute(type.name + ": tau has no trace", of_trace, 0., 1e-14);
  check::absolute(type.name + ": one stress by both functions", of_both, 0., 1e-15);
  check::absolute(type.name + ": energy's derivative is the stress", of_energy, 0., 2e-9);
  check::absolute(type.name + ": stress's derivative is the tangent", of_stress, 0., 2e-9);
  check::absolute(type.name + ": derivative of the mean stress", of_mean, 0., 2e-9);
  check::absolute(type.name + ": a rotation turns the stress", of_rotation, 0., 1e-13);
  check::absolute(type.name + ": a rotation leaves the energy", of_rotated_energy, 0., 1e-13);
}

/// Without fibres, which are of first order in the strain, too.
void check_small_strains(const StrainLawType &type, const StrainLaw &law)
{
  std::mt19937 random(5);
  const Tensor2 g = random_tensor(random, 1.);
  const Symmetric2 e = symmetrize(g);
  const auto at = [&](const double h) { return strain_of(unit_tensor() + h * g); };
  const double h = 1e-4;
  const Symmetric2 slope = (stress_of(law, at(h)) - stress_of(law, at(-h))) / (2. * h);
  check::absolute(type.name + ": 2 mu dev e", (slope - 2. * mu * deviator(e)).norm(), 0., 1e-6);
  check::relative(type.name + ": shear modulus at zero strain", law.shear_modulus(), mu, 1e-15);
  const double trace_energy =
      law.has_own_mean_stress() ? 0.5 * bulk_modulus * trace(e) * trace(e) : 0.;
  // A difference of 1 + e and 1 would have two digits here.
  const double tiny = 1e-7;
  check::relative(type.name + ": mu dev e : dev e",
                  0.5 * (law.energy(at(tiny)) + law.energy(at(-tiny))) / (tiny * tiny),
                  mu * (deviator(e) * deviator(e)) + trace_energy, 1e-7);
  if (law.has_own_mean_stress())
    check::relative(type.name + ": K tr e",
                    (mean_kirchhoff_stress(law, at(h)) - mean_kirchhoff_stress(law, at(-h))) /
                        (2. * h),
                    bulk_modulus * trace(e), 1e-6);
  const PointStrain turned = strain_of(random_rotation(random));
  check::absolute(type.name + ": a rotation alone", stress_of(law, turned).norm(), 0., 1e-14);
  check::absolute(type.name + ": its energy", law.energy(turned), 0., 1e-15);
}

Tensor2 diagonal(const double a, const double b, const double c)
{
  Tensor2 f;
  f[0][0] = a;
  f[1][1] = b;
  f[2][2] = c;
  return f;
}

/// At constant volume, by the textbooks.
void check_closed_forms()
{
  const double l = 1.7, gamma = 0.9;
  const PointStrain uniaxial = strain_of(diagonal(l, 1. / std::sqrt(l), 1. / std::sqrt(l))),
                    biaxial = strain_of(diagonal(l, l, 1. / (l * l))),
                    planar = strain_of(diagonal(l, 1., 1. / l));
  Tensor2 sheared = unit_tensor();
  sheared[0][1] = gamma;
  const PointStrain shear = strain_of(sheared);
  const auto axial = [](const Symmetric2 &stress) { return stress[0][0] - stress[2][2]; };

  const auto rubber = make_strain_law(some_law("neo hookean"), mu, bulk_modulus);
  check::relative("neo hookean: uniaxial", axial(stress_of(*rubber, uniaxial)),
                  mu * (l * l - 1. / l), 1e-14);
  check::relative("neo hookean: equibiaxial", axial(stress_of(*rubber, biaxial)),
                  mu * (l * l - std::pow(l, -4)), 1e-14);
  check::relative("neo hookean: planar", axial(stress_of(*rubber, planar)),
                  mu * (l * l - 1. / (l * l)), 1e-14);
  check::relative("neo hookean: shear", stress_of(*rubber, shear)[0][1], mu * gamma, 1e-14);
  check::relative("neo hookean: a change of volume leaves the energy",
                  rubber->energy(strain_of(1.3 * uniaxial.gradient)), rubber->energy(uniaxial),
                  1e-14);

  const double mu1 = 0.7 * mu, mu2 = 0.3 * mu;
  const auto mooney = make_strain_law(some_law("mooney rivlin"), mu, bulk_modulus);
  check::relative("mooney rivlin: uniaxial", axial(stress_of(*mooney, uniaxial)),
                  (mu1 + mu2 / l) * (l * l - 1. / l), 1e-14);
  check::relative("mooney rivlin: equibiaxial", axial(stress_of(*mooney, biaxial)),
                  (mu1 + mu2 * l * l) * (l * l - std::pow(l, -4)), 1e-14);
  check::relative("mooney rivlin: planar", axial(stress_of(*mooney, planar)),
                  (mu1 + mu2) * (l * l - 1. / (l * l)), 1e-14);
  check::relative("mooney rivlin: shear", stress_of(*mooney, shear)[0][1], mu * gamma, 1e-14);
  check::relative("mooney rivlin: energy", mooney->energy(uniaxial),
                  0.5 * mu1 * (l * l + 2. / l - 3.) + 0.5 * mu2 * (2. * l + 1. / (l * l) - 3.),
                  1e-13);

  const auto kirchhoff = make_strain_law(some_law("st venant kirchhoff"), mu, bulk_modulus);
  const double lambda = bulk_modulus - 2. / 3. * mu, green = 0.5 * (l * l - 1.);
  const PointStrain stretched = strain_of(diagonal(l, 1., 1.));
  const double along = l * l * (lambda + 2. * mu) * green, across = lambda * green;
  check::relative("st venant kirchhoff: uniaxial strain", axial(stress_of(*kirchhoff, stretched)),
                  along - across, 1e-14);
  check::relative("st venant kirchhoff: its mean stress",
                  mean_kirchhoff_stress(*kirchhoff, stretched), (along + 2. * across) / 3., 1e-14);
  check::relative("st venant kirchhoff: its energy", kirchhoff->energy(stretched),
                  (0.5 * lambda + mu) * green * green, 1e-14);
}
} // namespace

UNIT_TEST(strain_law)
{
  for (const StrainLawType &type : strain_law_types())
  {
    const auto law = make_strain_law(some_law(type.name), mu, bulk_modulus);
    check_derivatives(type, *law);
    check_small_strains(type, *law);
    check::is_true(type.name + ": own mean stress if and only if it needs a bulk modulus",
                   type.needs_bulk_modulus == law->has_own_mean_stress());
  }
  check_closed_forms();
  check::throws<std::logic_error>(
      "no mean stress of its own",
      []
      {
        double mean;
        Symmetric2 slope;
        make_strain_law(some_law("neo hookean"), mu, bulk_modulus)
            ->set_mean_stress(strain_of(unit_tensor()), mean, slope);
      },
      "no mean stress");
}
} // namespace test_of_strain_law
