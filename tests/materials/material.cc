// The constants of each law against values derived by hand (equations 2.4, 2.5 of the thesis), and
// what is refused.

#include <continua/materials/material.h>

#include "../check.h"
#include "../parameter_text.h"

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
const std::string water = "set Type = newtonian\nset Density = 998\nset Viscosity = 1 mPa s\n";
} // namespace

int main()
{
  // Y = 2.6 MPa, nu = 0.3: mu = 1 MPa, lambda = 1.5 MPa, K = lambda + 2 mu / 3.
  const Material hookean = read(solid("0.3"));
  check::relative("shear modulus", hookean.long_term_shear_modulus(), 1e6, 1e-14);
  check::relative("bulk modulus", 1. / hookean.inverse_bulk_modulus, 13e6 / 6., 1e-14);
  check::relative("longitudinal speed", hookean.longitudinal_speed(), 59.160797830996161, 1e-14);
  check::is_true("hookean: a solid without viscosity",
                 hookean.phase() == 1. && hookean.viscosity == 0. && hookean.branches.size() == 1 &&
                     std::isinf(hookean.branches[0].relaxation_time));
  check::absolute("pressure factor", hookean.pressure_factor, 1., 0.);

  // The same in plane stress: lambda = nu Y / ((1 + nu)(1 - nu)) = 6/7 MPa.
  const Material membrane = read(solid("0.3"), Model::plane_stress);
  check::relative("plane stress: bulk modulus", 1. / membrane.inverse_bulk_modulus, 32e6 / 21.,
                  1e-14);
  check::relative("plane stress: pressure factor", membrane.pressure_factor, 0.8125, 1e-14);
  check::relative("plane stress: thickness strain", membrane.thickness_strain_factor, -3. / 7.,
                  1e-14);

  const Material incompressible = read(solid("0.5"));
  check::absolute("nu = 0.5: 1/K", incompressible.inverse_bulk_modulus, 0., 0.);
  check::relative("nu = 0.5: shear modulus", incompressible.long_term_shear_modulus(), 2.6e6 / 3.,
                  1e-14);
  check::is_true("nu = 0.5: speed", std::isinf(incompressible.longitudinal_speed()));
  const Material sheet = read(solid("0.5"), Model::plane_stress);
  check::relative("nu = 0.5, plane stress: K = 8 Y / 9", 1. / sheet.inverse_bulk_modulus,
                  8. * 2.6e6 / 9., 1e-14);
  check::relative("nu = 0.5, plane stress: pressure factor", sheet.pressure_factor, 0.75, 1e-14);
  check::relative("nu = -0.9", 1. / read(solid("-0.9")).inverse_bulk_modulus, 2.6e6 / 8.4, 1e-14);

  const Material fluid = read(water + "set Bulk modulus = 2.2 GPa\n");
  check::relative("fluid: K", fluid.inverse_bulk_modulus, 1. / 2.2e9, 1e-14);
  check::relative("fluid: viscosity", fluid.viscosity, 1e-3, 1e-14);
  check::relative("fluid: speed of sound", fluid.longitudinal_speed(), std::sqrt(2.2e9 / 998.),
                  1e-14);
  check::absolute("fluid: phase", fluid.phase(), 0., 0.);
  check::absolute("fluid: incompressible",
                  read(water + "set Incompressible = true\n").inverse_bulk_modulus, 0., 0.);

  const Material voigt = read(solid("0.3", "kelvin-voigt") + "set Viscosity = 5 Pa s\n");
  check::absolute("kelvin-voigt: viscosity", voigt.viscosity, 5., 0.);
  const Material maxwell = read("set Type = maxwell\nset Density = 900\nset Bulk modulus = 4 MPa\n"
                                "set Shear modulus = 3 MPa\nset Relaxation time = 7 ms\n");
  check::is_true("maxwell: no long-term modulus", maxwell.long_term_shear_modulus() == 0. &&
                                                      maxwell.instantaneous_shear_modulus() == 3e6);
  check::relative("maxwell: relaxation time", maxwell.branches.at(0).relaxation_time, 7e-3, 1e-14);
  const Material prony = read(solid("0.3", "prony") + "set Shear moduli = 0.2 MPa, 0.1 MPa\n"
                                                      "set Relaxation times = 5 ms, 50 ms\n");
  check::relative("prony: long-term", prony.long_term_shear_modulus(), 1e6, 1e-14);
  check::relative("prony: instantaneous", prony.instantaneous_shear_modulus(), 1.3e6, 1e-14);
  check::relative("prony: K is that of the long-term modulus", 1. / prony.inverse_bulk_modulus,
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
                 power_law.is_solid() && power_law.inverse_bulk_modulus == 0.);
  const Material compressible = read("set Type = power law\nset Density = 880\n"
                                     "set Relaxation modulus at one second = 1.3 MPa\n"
                                     "set Exponent = 0.065\nset Bulk modulus = 5 MPa\n");
  check::relative(
      "power law: Young's modulus does not depend on K",
      std::abs(compressible.complex_young_modulus(3.) / power_law.complex_young_modulus(3.)), 1.,
      1e-14);
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
