// The constants of each law against values derived by hand (equations 2.4, 2.5 of the thesis), and
// what is refused.

#include <continua/materials/material.h>
#include <continua/materials/mean_modulus.h>
#include <continua/materials/plane_stress.h>

#include "../parameter_text.h"
#include "../unit_test.h"

namespace test_of_material
{
using namespace Continua;

namespace
{
Material read(const std::string &text, const Model model = Model::plane_strain)
{
  ParameterFile file = parameters_of(text);
  const Material material = read_material(file.root(), model);
  file.refuse_unknown();
  return material;
}

void refused(const std::string &name,
             const std::string &text,
             const std::string &pattern,
             const Model model = Model::plane_strain)
{
  check::throws<InputError>(
      name, [&] { read(text, model); }, "parameters_of_the_test.prm.*" + pattern);
}

std::string solid(const std::string &ratio, const std::string &type = "hookean")
{
  return "set Type = " + type + "\nset Density = 1000 kg/m^3\nset Young's modulus = 2.6 MPa\n" +
         "set Poisson's ratio = " + ratio + "\n";
}

PlaneStressFactors factors(const std::string &ratio)
{
  ParameterFile file = parameters_of(solid(ratio));
  read_material(file.root(), Model::plane_stress);
  const PlaneStressFactors result = read_plane_stress_factors(file.root());
  file.refuse_unknown();
  return result;
}

/// nu = (3 K - 2 mu)/(6 K + 2 mu) in harmonic motion: this number, real, at all frequencies.
void check_ratio(const std::string &name, const Material &material, const double ratio)
{
  double largest = 0.;
  for (const double omega : {0.1, 3., 20., 143., 1e4})
  {
    const std::complex<double> bulk = 1. / material.complex_inverse_bulk_modulus(omega);
    const std::complex<double> mu = material.complex_shear_modulus(omega);
    largest = std::max(largest, std::abs((3. * bulk - 2. * mu) / (6. * bulk + 2. * mu) - ratio));
  }
  check::absolute(name, largest, 0., 1e-13);
}

const std::string water = "set Type = newtonian\nset Density = 998\nset Viscosity = 1 mPa s\n";
} // namespace

UNIT_TEST(material)
{
  // Y = 2.6 MPa, nu = 0.3: mu = 1 MPa, lambda = 1.5 MPa, K = lambda + 2 mu / 3.
  const Material hookean = read(solid("0.3"));
  check::relative("shear modulus", hookean.long_term_shear_modulus(), 1e6, 1e-14);
  check::relative("bulk modulus", 1. / hookean.inverse_bulk_modulus(), 13e6 / 6., 1e-14);
  check::relative("longitudinal speed", hookean.longitudinal_speed(), 59.160797830996161, 1e-14);
  check::is_true("hookean: a solid without viscosity",
                 hookean.phase() == 1. && hookean.shear.viscosity == 0. &&
                     hookean.shear.branches.size() == 1 &&
                     std::isinf(hookean.shear.branches[0].relaxation_time));
  check::absolute("pressure factor", PlaneStressFactors().pressure_factor, 1., 0.);

  // The same in plane stress: lambda = nu Y / ((1 + nu)(1 - nu)) = 6/7 MPa.
  const Material membrane = read(solid("0.3"), Model::plane_stress);
  check::relative("plane stress: bulk modulus", 1. / membrane.inverse_bulk_modulus(), 32e6 / 21.,
                  1e-14);
  check::relative("plane stress: pressure factor", factors("0.3").pressure_factor, 0.8125, 1e-14);
  check::relative("plane stress: thickness strain", factors("0.3").thickness_strain_factor,
                  -3. / 7., 1e-14);

  const Material incompressible = read(solid("0.5"));
  check::absolute("nu = 0.5: 1/K", incompressible.inverse_bulk_modulus(), 0., 0.);
  check::relative("nu = 0.5: shear modulus", incompressible.long_term_shear_modulus(), 2.6e6 / 3.,
                  1e-14);
  check::is_true("nu = 0.5: speed", std::isinf(incompressible.longitudinal_speed()));
  const Material sheet = read(solid("0.5"), Model::plane_stress);
  check::relative("nu = 0.5, plane stress: K = 8 Y / 9", 1. / sheet.inverse_bulk_modulus(),
                  8. * 2.6e6 / 9., 1e-14);
  check::relative("nu = 0.5, plane stress: pressure factor", factors("0.5").pressure_factor, 0.75,
                  1e-14);
  check::relative("nu = -0.9", 1. / read(solid("-0.9")).inverse_bulk_modulus(), 2.6e6 / 8.4, 1e-14);

  const Material fluid = read(water + "set Bulk modulus = 2.2 GPa\n");
  check::relative("fluid: K", fluid.inverse_bulk_modulus(), 1. / 2.2e9, 1e-14);
  check::relative("fluid: viscosity", fluid.shear.viscosity, 1e-3, 1e-14);
  check::relative("fluid: speed of sound", fluid.longitudinal_speed(), std::sqrt(2.2e9 / 998.),
                  1e-14);
  check::absolute("fluid: phase", fluid.phase(), 0., 0.);
  check::absolute("fluid: incompressible",
                  read(water + "set Incompressible = true\n").inverse_bulk_modulus(), 0., 0.);

  const Material voigt = read(solid("0.3", "kelvin-voigt") + "set Viscosity = 5 Pa s\n");
  check::absolute("kelvin-voigt: viscosity", voigt.shear.viscosity, 5., 0.);
  const Material maxwell = read("set Type = maxwell\nset Density = 900\nset Bulk modulus = 4 MPa\n"
                                "set Shear modulus = 3 MPa\nset Relaxation time = 7 ms\n");
  check::is_true("maxwell: no long-term modulus", maxwell.long_term_shear_modulus() == 0. &&
                                                      maxwell.instantaneous_shear_modulus() == 3e6);
  check::relative("maxwell: relaxation time", maxwell.shear.branches.at(0).relaxation_time, 7e-3,
                  1e-14);
  const Material prony = read(solid("0.3", "prony") + "set Shear moduli = 0.2 MPa, 0.1 MPa\n"
                                                      "set Relaxation times = 5 ms, 50 ms\n");
  check::relative("prony: long-term", prony.long_term_shear_modulus(), 1e6, 1e-14);
  check::relative("prony: instantaneous", prony.instantaneous_shear_modulus(), 1.3e6, 1e-14);
  check::relative("prony: K is that of the long-term modulus", 1. / prony.inverse_bulk_modulus(),
                  13e6 / 6., 1e-14);

  // Harmonic motion. Maxwell at omega tau = 1: mu (1 + i)/2. Liquid: i omega eta.
  const std::complex<double> relaxed = maxwell.complex_shear_modulus(1. / 7e-3);
  check::relative("maxwell: storage modulus", relaxed.real(), 1.5e6, 1e-14);
  check::relative("maxwell: loss modulus", relaxed.imag(), 1.5e6, 1e-14);
  check::relative("fluid: loss modulus", fluid.complex_shear_modulus(10.).imag(), 1e-2, 1e-14);
  check::relative("hookean: Young's modulus", hookean.complex_young_modulus(5.).real(), 2.6e6,
                  1e-14);
  // A power law with n = 0.065: tan delta = tan(n pi/2) = 0.10245, Gamma(0.935) = 1.0426; c
  // = 1.3e6.
  const Material power_law = read("set Type = power law\nset Density = 880\n"
                                  "set Relaxation modulus at one second = 1.3 MPa\n"
                                  "set Exponent = 0.065\n");
  const std::complex<double> young = power_law.complex_young_modulus(1.);
  check::relative("power law: loss tangent", young.imag() / young.real(), 0.10245, 1e-3);
  check::relative("power law: modulus", std::abs(young), 1.0426 * 1.3e6, 1e-3);
  check::is_true("power law: a solid, incompressible unless told otherwise",
                 power_law.is_solid() && power_law.is_incompressible());
  const Material compressible = read("set Type = power law\nset Density = 880\n"
                                     "set Relaxation modulus at one second = 1.3 MPa\n"
                                     "set Exponent = 0.065\nset Bulk modulus = 5 MPa\n");
  check::relative(
      "power law: Young's modulus does not depend on K",
      std::abs(compressible.complex_young_modulus(3.) / power_law.complex_young_modulus(3.)), 1.,
      1e-14);

  // A volume change that relaxes. K/mu = 2(1 + nu)/(3(1 - 2 nu)) = 13/6 for nu = 0.3.
  const std::string two_branches = solid("0.3", "prony") + "set Shear moduli = 0.2 MPa, 0.1 MPa\n"
                                                           "set Relaxation times = 5 ms, 50 ms\n";
  const Material constant_ratio = read(two_branches + "set Volumetric relaxation = as the shear\n");
  check::is_true("prony, as the shear: a spring and two branches",
                 constant_ratio.compression.bulk_branches().size() == 3 &&
                     std::isinf(constant_ratio.compression.bulk_branches()[0].relaxation_time) &&
                     constant_ratio.compression.bulk_branches()[1].relaxation_time == 5e-3 &&
                     constant_ratio.compression.bulk_branches()[2].relaxation_time == 50e-3);
  check::relative("prony, as the shear: K of a branch",
                  constant_ratio.compression.bulk_branches().at(1).bulk_modulus, 0.2e6 * 13. / 6.,
                  1e-13);
  check::relative("prony, as the shear: instantaneous K",
                  1. / constant_ratio.inverse_bulk_modulus(), 1.3e6 * 13. / 6., 1e-13);
  check::relative("prony, as the shear: long-term K",
                  1. / constant_ratio.long_term_inverse_bulk_modulus(), 13e6 / 6., 1e-13);
  check::relative("prony, as the shear: longitudinal speed", constant_ratio.longitudinal_speed(),
                  std::sqrt(1.3) * 59.160797830996161, 1e-13);
  check_ratio("prony, as the shear: Poisson's ratio", constant_ratio, 0.3);
  // mu(omega) at omega = 1/50 ms: 1e6 + 0.2e6 x/(1 + x) + 0.1e6 i/(1 + i), x = i/10; Y = 2.6 mu.
  const std::complex<double> young_20 = constant_ratio.complex_young_modulus(20.);
  check::relative("prony, as the shear: storage modulus", young_20.real(),
                  2.6 * (1e6 + 0.2e6 / 101. + 0.05e6), 1e-13);
  check::relative("prony, as the shear: loss modulus", young_20.imag(),
                  2.6 * (0.2e6 * 10. / 101. + 0.05e6), 1e-13);
  const Material incompressible_ratio =
      read(solid("0.5", "prony") + "set Shear moduli = 1 MPa\nset Relaxation times = 1 s\n"
                                   "set Volumetric relaxation = as the shear\n");
  check::is_true("prony, as the shear, nu = 0.5: incompressible",
                 incompressible_ratio.is_incompressible() &&
                     incompressible_ratio.compression.bulk_branches().empty());

  const Material own = read(two_branches + "set Volumetric relaxation = own branches\n"
                                           "set Bulk moduli = 3 MPa\n"
                                           "set Bulk relaxation times = 20 ms\n");
  check::relative("prony, own branches: long-term K", 1. / own.long_term_inverse_bulk_modulus(),
                  13e6 / 6., 1e-13);
  check::relative("prony, own branches: instantaneous K", 1. / own.inverse_bulk_modulus(),
                  13e6 / 6. + 3e6, 1e-13);
  const std::complex<double> bulk = 1. / own.complex_inverse_bulk_modulus(50.);
  check::relative("prony, own branches: Re K at omega tau = 1", bulk.real(), 13e6 / 6. + 1.5e6,
                  1e-13);
  check::relative("prony, own branches: Im K at omega tau = 1", bulk.imag(), 1.5e6, 1e-13);

  const std::string liquid_like = "set Type = maxwell\nset Density = 900\n"
                                  "set Shear modulus = 3 MPa\nset Relaxation time = 7 ms\n";
  const Material all_relaxes =
      read(liquid_like + "set Bulk modulus = 4 MPa\nset Volumetric relaxation = as the shear\n");
  check::is_true("maxwell, as the shear: no long-term K",
                 std::isinf(all_relaxes.long_term_inverse_bulk_modulus()) &&
                     all_relaxes.inverse_bulk_modulus() == 1. / 4e6);
  check::relative("maxwell, as the shear: K at omega tau = 1",
                  (1. / all_relaxes.complex_inverse_bulk_modulus(1. / 7e-3)).imag(), 2e6, 1e-13);
  // nu of K = 4 MPa, mu = 3 MPa: (3 K - 2 mu)/(6 K + 2 mu) = 0.2.
  check_ratio("maxwell, as the shear: Poisson's ratio", all_relaxes, 0.2);

  const std::string law = "set Type = power law\nset Density = 880\n";
  const std::string numbers = "set Relaxation modulus at one second = 1.3 MPa\n"
                              "set Exponent = 0.065\n";
  const Material law_of_ratio = read(
      law + numbers + "set Volumetric relaxation = as the shear\nset Poisson's ratio = 0.45\n");
  check_ratio("power law, as the shear: Poisson's ratio", law_of_ratio, 0.45);
  check::relative(
      "power law, as the shear: Young's modulus is the law",
      std::abs(law_of_ratio.complex_young_modulus(3.) / power_law.complex_young_modulus(3.)), 1.,
      1e-13);
  check::is_true("kinds of compression",
                 hookean.compression.kind() == Compression::Kind::elastic &&
                     incompressible.compression.kind() == Compression::Kind::incompressible &&
                     all_relaxes.compression.kind() == Compression::Kind::relaxing &&
                     Compression::elastic(0.).is_incompressible());
  check::is_true("what relaxes", !hookean.relaxes() && prony.relaxes() && all_relaxes.relaxes() &&
                                     power_law.relaxes() && power_law.has_power_law() &&
                                     !prony.has_power_law());
  check::is_true("power law: how the fit is asked for",
                 law_of_ratio.shear.power_law->prony_fit.n_branches == 0 &&
                     law_of_ratio.shear.power_law->prony_fit.tolerance == 5e-4);

  // The mean modulus of the thesis is 1.72 MPa (section 5.3). It belongs to a fundamental of 0.42
  // Hz; at 0.5 Hz its 40 harmonics have a mean of c Gamma(1 - n) cos(n pi/2) pi^n sum i^n/40 =
  // 1.739266 MPa.
  check::relative("mean modulus of 40 harmonics of 0.5 Hz", mean_modulus(power_law, 0.5),
                  1.739266e6, 1e-6);
  check::relative("mean modulus of 40 harmonics of 0.42125 Hz", mean_modulus(power_law, 0.42125),
                  1.72e6, 1e-5);
  check::relative("mean modulus: 0.5 Hz is 1.2 % off the thesis", mean_modulus(power_law, 0.5),
                  1.72e6, 0.012);
  check::relative("mean modulus of a Hookean solid", mean_modulus(hookean, 3., 7), 2.6e6, 1e-13);

  refused("own branches without moduli",
          two_branches + "set Volumetric relaxation = own branches\n", "'Bulk moduli'");
  refused("as many bulk times as moduli",
          two_branches +
              "set Volumetric relaxation = own branches\nset Bulk moduli = 1 MPa, 2 MPa\n"
              "set Bulk relaxation times = 1 s\n",
          ":9: 'Bulk relaxation times'.*2 bulk moduli.*1 relaxation");
  refused("bulk modulus of a branch 0",
          two_branches + "set Volumetric relaxation = own branches\nset Bulk moduli = 0 MPa\n"
                         "set Bulk relaxation times = 1 s\n",
          ":8: 'Bulk moduli'.*> 0");
  refused("own branches of an incompressible solid",
          solid("0.5", "prony") + "set Shear moduli = 1 MPa\nset Relaxation times = 1 s\n"
                                  "set Volumetric relaxation = own branches\n"
                                  "set Bulk moduli = 1 MPa\nset Bulk relaxation times = 1 s\n",
          ":7: 'Volumetric relaxation'.*incompressible");
  refused("an incompressible Maxwell solid",
          liquid_like + "set Incompressible = true\nset Volumetric relaxation = as the shear\n",
          ":6: 'Volumetric relaxation'.*incompressible");
  refused("own branches of a Maxwell solid",
          liquid_like + "set Bulk modulus = 4 MPa\nset Volumetric relaxation = own branches\n",
          ":6: 'Volumetric relaxation'.*as the shear");
  refused("constant ratio 0.5 of a power law",
          law + numbers + "set Volumetric relaxation = as the shear\nset Poisson's ratio = 0.5\n",
          ":6: 'Poisson's ratio'.*< 0.5");
  refused("a bulk modulus beside the constant ratio of a power law",
          law + numbers +
              "set Volumetric relaxation = as the shear\nset Poisson's ratio = 0.4\n"
              "set Bulk modulus = 1 MPa\n",
          ":7.*Bulk modulus");
  refused("more branches than are tried", law + numbers + "set Branches = 41\n",
          ":5: 'Branches'.*40");
  refused("shear modulus of a branch negative",
          solid("0.3", "prony") + "set Shear moduli = -1 MPa\nset Relaxation times = 1 s\n",
          ":5: 'Shear moduli'.*> 0");
  refused("power law without numbers", law, "'Relaxation modulus at one second' is missing");
  refused("exponent 1",
          "set Type = power law\nset Density = 880\n"
          "set Relaxation modulus at one second = 1 MPa\nset Exponent = 1\n",
          ":4: 'Exponent'");
  refused("ratio above 0.5", solid("0.5001"), ":4: 'Poisson's ratio'.*0.5001.*0.5");
  refused("ratio -1", solid("-1"), ":4: 'Poisson's ratio'");
  refused("plane stress, ratio below -0.5", solid("-0.6"), ":4: 'Poisson's ratio'.*plane stress",
          Model::plane_stress);
  refused("negative density", "set Type = hookean\nset Density = -1\n", ":2: 'Density'.*-1");
  refused("density missing", "set Type = hookean\n", "'Density'");
  refused("wrong unit", "set Type = hookean\nset Density = 1 Pa\n", ":2: 'Density'.*Pa.*kg/m\\^3");
  refused("plane stress with a fluid", water, ":1: 'Type'.*Hookean", Model::plane_stress);
  refused("plane stress with relaxation", solid("0.3", "prony"), ":1: 'Type'.*Hookean",
          Model::plane_stress);
  refused("bulk modulus of an incompressible fluid",
          water + "set Incompressible = true\nset Bulk modulus = 1 GPa\n", ":5: 'Bulk modulus'");
  refused("bulk modulus missing", water, "'Bulk modulus'");
  refused("as many times as moduli",
          solid("0.3", "prony") + "set Shear moduli = 1 MPa, 2 MPa\nset Relaxation times = 1 s\n",
          ":6: 'Relaxation times'.*2 shear moduli.*1 relaxation");
  refused("relaxation time 0",
          solid("0.3", "prony") + "set Shear moduli = 1 MPa\nset Relaxation times = 0 s\n",
          ":6: 'Relaxation times'");
  refused("unknown law", "set Type = rubber\n", ":1: 'Type'.*rubber.*hookean");
  refused("entry of another law", solid("0.3") + "set Viscosity = 1\n", ":5.*Viscosity");
}
} // namespace test_of_material
