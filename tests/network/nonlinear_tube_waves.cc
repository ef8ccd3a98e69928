// The nonlinear theory of a tube: small waves against linear theory, a wave of finite height
// against characteristics, the table of a wall law against its closed form, and what the theory
// refuses.

#include <continua/network/neo_hookean_wall.h>
#include <continua/network/nonlinear_tube_waves.h>
#include <continua/network/tabulated_wall.h>
#include <continua/network/tube_wall.h>
#include <continua/theory/korteweg.h>
#include <continua/theory/loaded_tube.h>
#include <continua/theory/saint_venant_kirchhoff_tube.h>
#include <continua/theory/tube_wave_theory.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "../unit_test.h"

namespace test_of_nonlinear_tube_waves
{
using namespace Continua;

namespace
{
constexpr double radius = 0.01, thickness = 1e-3, young = 4e5, density = 1000.; // m, m, Pa, kg/m^3
constexpr double length = 0.5;                                                  // m

/// Of an incompressible wall, with branches and a viscosity beside the spring, and a viscous
/// liquid.
TubeSection
section_of(const double viscosity_of_wall, const std::vector<Branch> &branches, const bool tethered)
{
  Material wall;
  wall.density = density;
  wall.shear.viscosity = viscosity_of_wall;
  wall.shear.branches = {Branch{young / 3.}};
  wall.shear.branches.insert(wall.shear.branches.end(), branches.begin(), branches.end());
  TubeSection section;
  section.inner_radius = radius;
  section.fluid.density = density;
  section.fluid.shear.viscosity = 4e-3;
  section.layer_thicknesses = {thickness};
  section.layers = {wall};
  section.tethered = tethered;
  return section;
}

/// Smooth; zero before t = 0 to 1e-8.
std::function<double(double)> pulse(const double height)
{
  return [height](const double time)
  {
    const double distance = (time - 0.23) / 0.05;
    return time > 0. ? height * std::exp(-distance * distance) : 0.;
  };
}

TubeWaveProblem problem_of(const TubeSection &section)
{
  TubeWaveProblem problem;
  problem.level = WaveLevel::womersley;
  problem.segments = {TubeSegment{length, section}};
  return problem;
}

/// Compares all fields at a place with those of linear theory: the largest differences, relative to
/// the largest values.
void compare(const std::string &name,
             const TubeWaveProblem &problem,
             const double tolerance,
             const unsigned int branch = 0,
             const double share_of_hoop_stress = 1.)
{
  // Small: the area grows by less than 1e-6 of itself.
  const double height = problem.inlet == TubeWaveProblem::Inlet::pressure ? 0.03 : 2e-9;
  NonlinearTubeWaves::Settings settings;
  settings.cell_length = length / 300.;
  const double end_time = 0.6;
  const NonlinearTubeWaves nonlinear(problem, pulse(height), settings);
  const TubeWaveTheory linear(problem, pulse(height), end_time, 1e-9);
  std::vector<double> times;
  constexpr unsigned int n_times = 100;
  for (unsigned int i = 1; i <= n_times; ++i)
    times.push_back(i * end_time / n_times);
  const std::vector<double> places = {0.3025}; // the middle of a segment of the taper
  const WaveHistory found = nonlinear.histories(places, times, branch)[0],
                    expected = linear.histories(places, times, branch)[0];
  const auto check_field = [&](const std::string &field, std::vector<double> WaveHistory::*member,
                               const double factor = 1.)
  {
    double largest = 0., difference = 0.;
    for (unsigned int i = 0; i < n_times; ++i)
    {
      largest = std::max(largest, std::abs((expected.*member)[i]));
      difference = std::max(difference, std::abs((found.*member)[i] - (expected.*member)[i]));
    }
    check::absolute(name + ", " + field, difference / largest, 0., factor * tolerance);
  };
  check_field("pressure", &WaveHistory::pressure);
  check_field("axis pressure", &WaveHistory::axis_pressure);
  check_field("flow rate", &WaveHistory::flow_rate);
  check_field("wall distension", &WaveHistory::wall_distension);
  // What is remembered is that of the middle of a step.
  check_field("wall shear stress", &WaveHistory::wall_shear_stress, 30.);
  // The formulas of linear theory let the wall bear what its support bears.
  if (share_of_hoop_stress == 1.)
    check_field("hoop stress", &WaveHistory::hoop_stress);
  else
    check::relative(name + ", hoop stress",
                    *std::max_element(found.hoop_stress.begin(), found.hoop_stress.end()),
                    share_of_hoop_stress *
                        *std::max_element(expected.hoop_stress.begin(), expected.hoop_stress.end()),
                    1e-3);
  check::is_true(name + ", it has no end", found.end.empty());
}

void small_waves()
{
  using Outlet = TubeWaveProblem::Outlet;
  TubeWaveProblem problem = problem_of(section_of(0., {}, true));
  compare("closed, held", problem, 3e-4);
  problem = problem_of(section_of(0., {}, false));
  problem.outlet = Outlet::open;
  compare("open, free along its axis", problem, 3e-4);
  // Of thick walls there is no formula of long waves with friction.
  problem = problem_of(section_of(young / 3. * 0.005, {Branch{young / 10., 0.02}}, true));
  problem.inlet = TubeWaveProblem::Inlet::flow_rate;
  problem.outlet = Outlet::loaded;
  problem.load = Impedance::windkessel(5e6, 5e7, 2e-9);
  compare("windkessel, wall that relaxes", problem, 3e-4);
  problem.load = Impedance::resistance(2e7);
  problem.segments.front().section.radial_stiffness = 2e6;
  TubeSection &supported = problem.segments.front().section;
  supported.layers.front().shear.branches.resize(1);
  supported.layers.front().shear.viscosity = 0.;
  compare("resistance, supported wall", problem, 3e-4, 0,
          supported.membrane_modulus(0.).real() / supported.hoop_modulus(0.).real());

  // What is around damps, too, as the complex modulus of linear theory has it.
  supported.radial_damping = 2e3;
  supported.layers.front().shear.branches.push_back(Branch{young / 10., 0.02});
  constexpr double omega = 30.;
  const WallRelaxation relaxation = TubeWall(supported, WallTheory::thin).relaxation();
  std::complex<double> modulus(1., omega * relaxation.damping_time);
  for (const WallRelaxation::Branch &branch : relaxation.branches)
  {
    const std::complex<double> part(0., omega * branch.relaxation_time);
    modulus += branch.share * part / (1. + part);
  }
  check::absolute(
      "supported wall that relaxes",
      std::abs(modulus - supported.hoop_modulus(omega) / supported.hoop_modulus(0.).real()), 0.,
      1e-12);

  // A taper of many segments.
  problem = problem_of(section_of(0., {}, true));
  problem.segments.clear();
  constexpr unsigned int n_segments = 100;
  for (unsigned int i = 0; i < n_segments; ++i)
  {
    TubeSection section = section_of(0., {}, true);
    section.inner_radius *= 1. - 0.4 * (i + 0.5) / n_segments;
    section.layer_thicknesses.front() *= 1. + 0.2 * (i + 0.5) / n_segments;
    problem.segments.push_back({length / n_segments, section});
  }
  compare("taper", problem, 4e-4);

  // Two branches, of which one is open.
  problem = problem_of(section_of(0., {}, true));
  problem.outlet = Outlet::divided;
  for (const Outlet outlet : {Outlet::open, Outlet::closed})
  {
    TubeWaveProblem branch = problem_of(section_of(0., {}, true));
    branch.segments.front().section.inner_radius = outlet == Outlet::open ? 0.007 : 0.006;
    branch.outlet = outlet;
    problem.branches.push_back(branch);
  }
  for (const unsigned int branch : {0u, 1u, 2u})
    compare("vessel that divides, " + std::to_string(branch), problem, 4e-4, branch);
}

TubeSection rubber()
{
  TubeSection section = section_of(0., {}, true);
  section.fluid.shear.viscosity = 0.;
  section.layers.front().set_strain_law();
  return section;
}

/// A wave that runs into liquid at rest carries each area at the speed u + c, u the integral of c/A
/// dA (characteristics).
void simple_wave()
{
  const TubeSection section = rubber();
  const double area = FlowLaw::pi * radius * radius, density_of_liquid = section.fluid.density;
  const NeoHookeanWall wall(area, section.wall_area(), 0., young / 3.);
  const auto speed = [&](const double of_area)
  { return std::sqrt(of_area * wall.stiffness(of_area) / density_of_liquid); };
  // The crest is 10 % wider.
  const double crest = area * 1.21;
  double velocity = 0.;
  constexpr unsigned int n = 1000;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double middle = area + (i + 0.5) * (crest - area) / n;
    velocity += speed(middle) / middle * (crest - area) / n;
  }
  const double flow = crest * velocity, duration = 0.2;
  TubeWaveProblem problem = problem_of(section);
  problem.inlet = TubeWaveProblem::Inlet::flow_rate;
  problem.outlet = TubeWaveProblem::Outlet::absorbing;
  NonlinearTubeWaves::Settings settings;
  settings.cell_length = length / 200.;
  const NonlinearTubeWaves waves(
      problem,
      [&](const double time)
      {
        const double sine = std::sin(FlowLaw::pi * time / duration);
        return time < duration ? flow * sine * sine : 0.;
      },
      settings);
  std::vector<double> times;
  constexpr unsigned int n_times = 1200;
  for (unsigned int i = 0; i <= n_times; ++i)
    times.push_back(0.3 * i / n_times);
  const std::vector<double> places = {0.2, 0.4};
  const std::vector<WaveHistory> histories = waves.histories(places, times, 0);
  for (unsigned int s = 0; s < 2; ++s)
  {
    const WaveHistory &history = histories[s];
    const std::size_t top = std::max_element(history.pressure.begin(), history.pressure.end()) -
                            history.pressure.begin();
    const double left = history.pressure[top - 1], middle = history.pressure[top],
                 right = history.pressure[top + 1],
                 time = times[top] +
                        (times[1] - times[0]) * 0.5 * (left - right) / (left - 2. * middle + right);
    check::relative("crest passes", time - 0.5 * duration, places[s] / (velocity + speed(crest)),
                    2e-3);
    check::relative("pressure of the crest", middle, wall.pressure(crest), 1e-3);
    check::relative("distension of the crest", history.wall_distension[top], 0.2 * radius, 2e-3);
    // The balance of forces: the stress over the wall's present section bears p a.
    const double inner = 1.1 * radius,
                 outer = std::sqrt(inner * inner + section.wall_area() / FlowLaw::pi);
    check::relative("hoop stress of the crest", history.hoop_stress[top],
                    wall.pressure(crest) * inner / (outer - inner), 2e-3);
  }
}

void table_of_a_wall()
{
  const TubeSection section = rubber();
  const double area = FlowLaw::pi * radius * radius;
  const LoadedTube tube(section);
  const NeoHookeanWall exact(area, section.wall_area(), 50., young / 3.);
  const TabulatedWall wall(
      area, [&](const double inner) { return tube.pressure(inner); }, 50.);
  double of_pressure = 0., of_stiffness = 0., of_area = 0.;
  for (double part = 0.5; part < 1.8; part += 0.0137)
  {
    const double here = part * area;
    of_pressure = std::max(of_pressure, std::abs(wall.pressure(here) - exact.pressure(here)));
    of_stiffness =
        std::max(of_stiffness, std::abs(wall.stiffness(here) / exact.stiffness(here) - 1.));
    of_area = std::max(of_area, std::abs(wall.area(wall.pressure(here), 0.) / here - 1.));
  }
  check::absolute("table, pressure over the modulus", of_pressure / young, 0., 1e-7);
  check::absolute("table, stiffness", of_stiffness, 0., 2e-4);
  check::absolute("table, area", of_area, 0., 1e-12);
  check::is_true("table, beyond it", std::isnan(wall.pressure(4. * area)) &&
                                         std::isnan(wall.area(1.01 * wall.largest_pressure(), 0.)));
}

/// A taper of layers whose law has no closed form takes the tables of a few ratios of thickness and
/// radius: two layers of rubber are as one.
void taper_of_tables()
{
  const auto section_at = [](const double z)
  {
    TubeSection section = rubber();
    section.inner_radius *= 1. - 0.4 * z / length;
    section.layer_thicknesses = {0.3 * thickness, 0.7 * thickness};
    section.layers.push_back(section.layers.front());
    // Mooney and Rivlin have the neo-Hookean law in plane strain.
    for (Material &layer : section.layers)
    {
      layer.strain_law_parameters.type = "mooney rivlin";
      layer.strain_law_parameters.mooney_rivlin_share = 0.3;
      layer.set_strain_law();
    }
    return section;
  };
  VesselDescription description;
  description.name = "taper";
  description.length = length;
  description.n_cells = 20;
  const std::unique_ptr<Vessel> vessel =
      TubeWall::make(description, FlowLaw(), section_at, WallTheory::thick, 0.);
  for (const Vessel::End end : {Vessel::End::start, Vessel::End::end})
  {
    const TubeSection section = section_at(end == Vessel::End::start ? 0. : length);
    const double area = FlowLaw::pi * section.inner_radius * section.inner_radius;
    const NeoHookeanWall exact(area, section.wall_area(), 0., young / 3.);
    check::relative("taper of tables", vessel->pressure(end, 1.3 * area),
                    exact.pressure(1.3 * area), 1e-6);
  }
  vessel->start_at_rest(1000.);
  const Vessel::Values middle = vessel->values(0.475 * length);
  const TubeSection section = section_at(0.475 * length);
  const NeoHookeanWall exact(FlowLaw::pi * section.inner_radius * section.inner_radius,
                             section.wall_area(), 0., young / 3.);
  check::relative("taper of tables, between them", exact.pressure(middle.area), 1000., 1e-4);
}

/// Walls linear in Green's strain: a thin one, which has p R/h = Y/(1 - nu^2) (stretch^2 - 1)/2,
/// and the stiffness of Lame's solution of a thick one, also of two layers.
void wall_of_saint_venant_and_kirchhoff()
{
  constexpr double nu = 0.4, modulus = young / (2. * (1. + nu));
  TubeSection section = section_of(0., {}, true);
  Material &wall = section.layers.front();
  wall.shear.branches = {Branch{modulus}};
  wall.compression = Compression::elastic(3. * (1. - 2. * nu) / young);
  wall.strain_law_parameters.type = "st venant kirchhoff";
  wall.set_strain_law();
  section.layer_thicknesses = {1e-6 * radius};
  const SaintVenantKirchhoffTube thin(section);
  for (const double stretch : {0.8, 1.1, 1.5})
    check::relative("thin wall of Saint-Venant and Kirchhoff", thin.pressure(stretch * radius),
                    1e-6 * young / (1. - nu * nu) * 0.5 * (stretch * stretch - 1.), 1e-5);
  section.layer_thicknesses = {0.3 * radius, 0.2 * radius};
  section.layers.push_back(wall);
  const SaintVenantKirchhoffTube thick(section);
  constexpr double step = 1e-5;
  const double stiffness =
      (thick.pressure((1. + step) * radius) - thick.pressure((1. - step) * radius)) /
      (2. * step * radius);
  const LongWaveTube lame{radius, 0.5 * radius, nu, density, 0.};
  const double speed = korteweg_speed(lame, young, Anchoring::throughout, WallTheory::thick).real();
  check::relative("thick wall of Saint-Venant and Kirchhoff, small strain",
                  0.5 * radius * stiffness, density * speed * speed, 1e-6);
  bool is_refused = false;
  try
  {
    section.layers.back().strain_law_parameters.type = "neo hookean";
    section.layers.back().set_strain_law();
    const SaintVenantKirchhoffTube other(section);
  }
  catch (const std::invalid_argument &)
  {
    is_refused = true;
  }
  check::is_true("a layer of another law", is_refused);
}

/// The mesh of a ring that was opened is much larger than the closed ring.
void opened_ring()
{
  TubeSection section = rubber();
  section.layers.front().prestretch.axial = 1.7;
  section.layers.front().prestretch.opening_angle = 160. / 180. * FlowLaw::pi;
  VesselDescription description;
  description.name = "ring";
  description.length = length;
  description.n_cells = 2;
  const std::unique_ptr<Vessel> vessel = TubeWall::make(
      description, FlowLaw(), [&](double) { return section; }, WallTheory::thick, 0.);
  const LoadedTube tube(section);
  for (const double pressure : {1., 1000.})
  {
    vessel->start_at_rest(pressure);
    const double inner = tube.inner_radius(pressure), area = FlowLaw::pi * inner * inner;
    check::relative("opened ring, area", vessel->values(0.5 * length).area, area, 1e-6);
    check::relative("opened ring, stiffness", vessel->stiffness(Vessel::End::start, area),
                    tube.stiffness(inner) / (2. * FlowLaw::pi * inner), 1e-4);
    check::relative("opened ring, hoop stress",
                    TubeWall(section, WallTheory::thick).hoop_stress(pressure, inner),
                    pressure * inner / (tube.outer_radius(inner) - inner), 1e-6);
  }
}

/// The text of the refusal; empty if there is none.
std::string refusal(const TubeWaveProblem &problem)
{
  NonlinearTubeWaves::Settings settings;
  settings.cell_length = 0.1;
  try
  {
    const NonlinearTubeWaves waves(problem, pulse(1.), settings);
  }
  catch (const std::domain_error &error)
  {
    return error.what();
  }
  return "";
}

void ends_and_refusals()
{
  // Near the largest pressure of rubber a wave is slow.
  NonlinearTubeWaves::Settings settings;
  settings.cell_length = length / 40.;
  const NonlinearTubeWaves waves(problem_of(rubber()), pulse(2e4), settings);
  const WaveHistory history = waves.histories({0.1}, {0.05, 0.4}, 0)[0];
  check::is_true("the theory ends where the liquid is as fast as the wave",
                 std::isfinite(history.pressure[0]) && std::isnan(history.pressure[1]) &&
                     history.end.find("as fast as the wave") != std::string::npos);

  const auto refused =
      [](const std::string &what, const TubeWaveProblem &problem, const std::string &reason)
  {
    const std::string text = refusal(problem);
    check::is_true("refused: " + what + " (" + text + ")", text.find(reason) != std::string::npos);
  };
  check::is_true("a tube", refusal(problem_of(section_of(0., {}, true))).empty());
  TubeSection section = section_of(0., {}, true);
  section.layers.clear();
  section.layer_thicknesses.clear();
  refused("rigid", problem_of(section), "no wall that gives way");
  section = rubber();
  section.tethered = false;
  refused("rubber that is free along", problem_of(section), "free along its axis");
  section = rubber();
  section.layers.front().shear.branches.push_back(Branch{young / 10., 0.02});
  check::is_true("rubber that relaxes", refusal(problem_of(section)).empty());
  section.layers.front().prestretch.axial = 1.1;
  refused("prestretch in a wall that relaxes", problem_of(section),
          "fibres or a prestretch that relaxes");
  section = section_of(0., {}, false);
  section.axial_stiffness = 1.;
  refused("support along the axis", problem_of(section), "support along its axis");
  section = section_of(0., {}, true);
  section.fluid.compression = Compression::elastic(1e-6);
  refused("gas", problem_of(section), "compressible beside the wall");
  TubeWaveProblem problem = problem_of(section_of(0., {}, true));
  problem.outlet = TubeWaveProblem::Outlet::loaded;
  problem.load = Impedance::windkessel(1., 1., 1.);
  problem.load.terms.push_back(problem.load.terms.front());
  refused("outlet of two compliances", problem, "neither a resistance nor a windkessel");
}
} // namespace

UNIT_TEST(nonlinear_tube_waves)
{
  small_waves();
  simple_wave();
  table_of_a_wall();
  taper_of_tables();
  wall_of_saint_venant_and_kirchhoff();
  opened_ring();
  ends_and_refusals();
}
} // namespace test_of_nonlinear_tube_waves
