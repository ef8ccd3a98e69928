// The numbers of the pre-flight report against scripts/references/waves/preflight.py, and each of
// its warnings.

#include <continua/case/before_the_run/preflight_report.h>

#include "../unit_test.h"

#include <algorithm>

namespace test_of_preflight_report
{
using namespace Continua;

namespace
{
Material water()
{
  Material material;
  material.type = "newtonian";
  material.density = 998.;
  material.compression = Compression::elastic(1. / 2.2e9);
  material.shear.viscosity = 1e-3;
  return material;
}

/// Y = 1.72 MPa, nu = 0.49.
Material rubber()
{
  Material material;
  material.type = "hookean";
  material.density = 880.;
  material.compression = Compression::elastic(3. * (1. - 2. * 0.49) / 1.72e6);
  Branch spring;
  spring.shear_modulus = 1.72e6 / (2. * 1.49);
  material.shear.branches.push_back(spring);
  return material;
}

/// Tube A at 20 Hz with a mesh and step without reproach.
PreflightInput tube()
{
  PreflightInput input;
  input.regions = {{"fluid", water(), 3e-3, 1e-4}, {"wall", rubber(), 3e-3, 1e-4}};
  input.step = crank_nicolson_step(0., 2e-4);
  input.end_time = 0.18;
  input.load = "inlet";
  input.frequency = 20.;
  input.is_tube = true;
  input.length = 0.446;
  input.axial_cell = 3e-3;
  input.normal_cell = 1.2e-4;
  for (PreflightInput::End &end : input.ends)
  {
    end.section.inner_radius = 0.0125;
    end.section.fluid = water();
    end.section.layer_thicknesses = {1e-4};
    end.section.layers = {rubber()};
    end.wall_is_clamped = true;
    end.wall_cell = 5.6e-4;
  }
  input.ends[0].boundary = "inlet";
  input.ends[1].boundary = "outlet";
  input.ends[1].flow_is_given = true;
  return input;
}

void numbers()
{
  const PreflightReport report(tube());
  const std::vector<std::pair<std::string, double>> expected = {
      {"load frequency", 20.},
      {"speed of sound, fluid", 1484.725165690698},
      {"longitudinal speed, wall", 182.8941621748959},
      {"bar speed, wall", 44.21024151195574},
      {"shear speed, wall", 25.61030527784956},
      {"Moens-Korteweg speed", 2.62560232616257},
      {"Korteweg speed, wall axially free", 2.615241564734113},
      {"Korteweg speed, wall axially held", 2.994494318373511},
      {"phase speed at the frequency", 2.547957756468},
      {"transit time", 0.1705387395237977},
      {"loss over the length", 0.0614134606360964},
      {"Womersley number", 139.984585496998},
      {"added-mass ratio", 141.7613636363636},
      {"added-mass ratio of the wave", 791.1474357491862},
      {"wavelength", 0.1273978878234},
      {"cells per wavelength", 0.1273978878234 / 3e-3},
      {"Stokes layer", 0.0001262829722779927},
      {"fluid cells in the Stokes layer", 0.0001262829722779927 / 1.2e-4},
      {"reflection, near end", -1.},
      {"reflection, far end", 1.},
      {"early reflection by the clamped far end", 0.0007142057691310108},
      {"time steps per period", 250.},
      {"numerical damping", 0.},
      // 1484.7 m/s over 0.1 mm in 0.2 ms.
      {"largest Courant number", 2969.450331381396},
      {"stiffest mode, factor per step", 1.},
  };
  for (const auto &[name, value] : expected)
    check::relative(name, report.value(name), value, 1e-10);
  check::is_true("no warning", report.warnings().empty());
  for (const std::string &warning : report.warnings())
    std::cout << warning << std::endl;
}

void outlets()
{
  // Ends of three times the tube's own impedance, rho c/(pi R^2), and of the tube itself.
  PreflightInput input = tube();
  const double of_tube = water().density * 2.615241564734113 /
                         (M_PI * std::pow(input.ends[1].section.inner_radius, 2));
  Outlet outlet;
  outlet.impedance = Impedance::resistance(3. * of_tube);
  input.ends[1].outlet = std::make_shared<const Outlet>(outlet);
  check::relative("reflection by a resistance", PreflightReport(input).value("reflection, far end"),
                  0.5, 1e-10);
  // The compliance of a windkessel takes all of the flow at high frequencies.
  outlet.impedance = Impedance::windkessel(of_tube, 1e9, 1e3);
  input.ends[1].outlet = std::make_shared<const Outlet>(outlet);
  check::absolute("reflection by a windkessel", PreflightReport(input).value("reflection, far end"),
                  0., 1e-6);
  input.ends[1].outlet = std::make_shared<const Outlet>();
  check::absolute("reflection by an absorbing end",
                  PreflightReport(input).value("reflection, far end"), 0., 0.);
}

void warns(const std::string &name, const PreflightInput &input, const std::string &pattern)
{
  const PreflightReport report(input);
  const bool one =
      report.warnings().size() == 1 && check::matches(report.warnings().front(), pattern);
  check::is_true(name, one);
  if (!one)
    for (const std::string &warning : report.warnings())
      std::cout << warning << std::endl;
}
void schemes()
{
  PreflightInput input = tube();
  input.step = backward_differencing_step(0., 2e-4, 2e-4, Update::implicit);
  check::relative("backward differencing", PreflightReport(input).value("numerical damping"),
                  8.962667361465676e-5, 1e-8);
  check::is_true("backward differencing does not warn", PreflightReport(input).warnings().empty());
  input.step = euler_step(0., 2e-4, Update::implicit);
  check::relative("Euler, implicit", PreflightReport(input).value("numerical damping"),
                  0.2473499289821358, 1e-10);
  warns("Euler damps", input, "takes 24.7 % of the amplitude");
  input.step = euler_step(0., 2e-4, Update::trapezoidal);
  const PreflightReport report(input);
  check::relative("Euler, trapezoidal", report.value("numerical damping"), 0.1324653842240056,
                  1e-10);
  check::is_true("Euler, trapezoidal, rings",
                 report.warnings().size() == 2 &&
                     check::matches(report.warnings().back(), "change their sign"));
}

void others()
{
  // Without a load the frequency is c/(4 L).
  PreflightInput input = tube();
  input.load.clear();
  input.frequency = 0.;
  check::relative("tube's own frequency", PreflightReport(input).value("tube's own frequency"),
                  2.615241564734113 / (4. * 0.446), 1e-10);
  // A tube whose radius and wall shrink alike has one speed from end to end.
  input = tube();
  input.ends[1].section.inner_radius *= 0.5;
  input.ends[1].section.layer_thicknesses[0] *= 0.5;
  check::relative("taper", PreflightReport(input).value("transit time"), 0.1705387395237977, 1e-10);
  input = tube();
  input.ends[0].section.tethered = input.ends[1].section.tethered = true;
  check::relative("tethered", PreflightReport(input).value("transit time"),
                  0.446 / 2.994494318373511, 1e-10);
  // A body that is no tube: sound of 1484.7 m/s and shear waves of 25.610 m/s at 20 Hz on cells of
  // 3 mm.
  input = tube();
  input.is_tube = false;
  const PreflightReport report(input);
  check::relative("sound", report.value("cells per wavelength, fluid"), 24745.4194281783, 1e-10);
  check::relative("shear", report.value("cells per wavelength, wall"), 426.838421297493, 1e-10);
  check::is_true("no tube", std::isnan(report.value("transit time")));
  input.regions[1].largest_cell = 0.2;
  warns("coarse body", input,
        "12.8 velocity nodes per wavelength at the load's frequency in 'wall'");
  check::equal("headline", PreflightReport(tube()).headline(),
               "Pre-flight: load of 20 Hz, tube wave 2.615 m/s, 170.5 ms to the far end; more in "
               "log.txt");
  const std::vector<std::string> lines =
      preflight_text("Pre-flight report", PreflightReport(tube()).entries());
  check::is_true("text", std::any_of(lines.begin(), lines.end(),
                                     [](const std::string &line) {
                                       return check::matches(line, "Stokes layer +126.3 um +sqrt");
                                     }));
}
} // namespace

UNIT_TEST(preflight_report)
{
  numbers();
  outlets();
  {
    PreflightInput input = tube();
    input.axial_cell = 0.02;
    warns("long cells", input, "12.* velocity nodes per wavelength");
    input = tube();
    input.normal_cell = 1.3e-4;
    warns("thick cells at the wall", input,
          "130 um, are thicker than the Stokes layer of 126.3 um");
    input = tube();
    input.ends[1].wall_cell = 1e-3;
    warns("long cells at a clamped end", input, "clamped far end, 1 mm long");
    input.ends[1].wall_is_clamped = false;
    check::is_true("which does not matter if it is free",
                   PreflightReport(input).warnings().empty());
    input.ends[1].rim_is_held = true;
    warns("but if the liquid's section holds its rim", input, "held far end, 1 mm long");
    input = tube();
    input.frequency = 300.;
    input.axial_cell = 1e-4;
    input.normal_cell = 1e-5;
    warns("few steps", input, "16.7 time steps per period");
    input = tube();
    input.frequency = 2000.;
    check::is_true(
        "above the ring frequency",
        check::matches(PreflightReport(input).warnings().front(), "above the ring frequency"));
  }
  schemes();
  others();
}
} // namespace test_of_preflight_report
