// Walls that relax and a friction that remembers, against the linear wave theory of the same
// material, against Womersley's flow, and at rest on a taper.

#include <continua/network/friction_memory.h>
#include <continua/network/network.h>
#include <continua/network/square_root_wall.h>
#include <continua/network/wall_material.h>
#include <continua/theory/tube_wave_theory.h>
#include <continua/theory/womersley.h>

#include <algorithm>
#include <cmath>

#include "../unit_test.h"

namespace test_of_vessel_memory
{
using namespace Continua;

namespace
{
constexpr double radius = 0.01, thickness = 1e-3, young = 4e5, density = 1000.; // m, m, Pa, kg/m^3
constexpr double area = FlowLaw::pi * radius * radius;
constexpr double length = 1.; // m

Material wall_of(const double viscosity, const std::vector<Branch> &branches)
{
  Material wall;
  wall.density = density;
  wall.shear.viscosity = viscosity;
  wall.shear.branches = {Branch{young / 3.}};
  wall.shear.branches.insert(wall.shear.branches.end(), branches.begin(), branches.end());
  return wall;
}

double speed()
{
  return std::sqrt(young * thickness / (2. * 0.75 * radius * density));
}

/// Smooth, with a height of `height`; zero before t = 0 to 1e-8.
std::function<double(double)> pulse(const double height)
{
  return [height](const double time)
  {
    const double distance = (time - 0.23) / 0.05;
    return time > 0. ? height * std::exp(-distance * distance) : 0.;
  };
}

struct Case
{
  Material wall;
  double viscosity = 0.; ///< of the liquid [Pa s]
  bool pressure_inlet = true;
  TerminalLaw::Type end = TerminalLaw::Type::closed;
  bool is_cut = false; ///< two vessels with a junction
  unsigned int n_cells = 400;
  double end_time = 0.7; ///< [s]: the pulse goes to the end and back, and again to the middle
};

Network network_of(const Case &of)
{
  FlowLaw law;
  law.density = density;
  law.viscosity = of.viscosity;
  law.remembers = of.viscosity > 0.;
  const WallRelaxation relaxation = WallMaterial::of(of.wall).relaxation;
  const auto vessel = [&](const double of_length, const unsigned int n_cells)
  {
    VesselDescription description;
    description.name = "tube";
    description.length = of_length;
    description.n_cells = n_cells;
    auto made = make_vessel<SquareRootWall>(
        description, law,
        [](double) { return SquareRootWall(area, 0., density * speed() * speed()); });
    if (!relaxation.is_elastic())
      made->set_relaxation(relaxation);
    return made;
  };
  TerminalLaw in, out;
  in.type = of.pressure_inlet ? TerminalLaw::Type::pressure : TerminalLaw::Type::flow_rate;
  // Small: the area grows by 5e-7 of itself.
  in.value = pulse(of.pressure_inlet ? 0.03 : 0.03 * area / (density * speed()));
  out.type = of.end;
  out.value = [](double) { return 0.; };
  std::vector<Network::Edge> edges;
  std::vector<TerminalLaw> terminals = {in};
  if (of.is_cut)
  {
    edges.push_back({vessel(0.4 * length, of.n_cells * 2 / 5), 0, 1});
    edges.push_back({vessel(0.6 * length, of.n_cells * 3 / 5), 1, 2});
    terminals.emplace_back();
  }
  else
    edges.push_back({vessel(length, of.n_cells), 0, 1});
  terminals.push_back(out);
  Network network(std::move(edges), terminals);
  network.start_at_rest(0.);
  return network;
}

/// The largest differences of pressure and flow rate from linear theory, relative to the largest
/// values, at a place.
std::pair<double, double> differences(const Case &of)
{
  TubeSection section;
  section.inner_radius = radius;
  section.fluid.density = density;
  section.fluid.shear.viscosity = of.viscosity;
  section.layer_thicknesses = {thickness};
  section.layers = {of.wall};
  section.tethered = true;
  TubeWaveProblem problem;
  problem.level = WaveLevel::womersley;
  problem.segments = {TubeSegment{length, section}};
  problem.inlet =
      of.pressure_inlet ? TubeWaveProblem::Inlet::pressure : TubeWaveProblem::Inlet::flow_rate;
  problem.outlet = of.end == TerminalLaw::Type::closed      ? TubeWaveProblem::Outlet::closed
                   : of.end == TerminalLaw::Type::absorbing ? TubeWaveProblem::Outlet::matched
                                                            : TubeWaveProblem::Outlet::open;
  const double height = of.pressure_inlet ? 0.03 : 0.03 * area / (density * speed());
  const TubeWaveTheory theory(problem, pulse(height), of.end_time, 1e-9);
  constexpr unsigned int n_times = 150;
  std::vector<double> times;
  for (unsigned int i = 1; i <= n_times; ++i)
    times.push_back(i * of.end_time / n_times);
  const double place = 0.6;
  const WaveHistory expected = theory.histories({place}, times)[0];
  Network network = network_of(of);
  double largest_pressure = 0., largest_flow = 0., of_pressure = 0., of_flow = 0.;
  for (unsigned int i = 0; i < n_times; ++i)
  {
    network.advance(times[i], 0.8);
    const Vessel::Values found = of.is_cut ? network.vessel(1).values(place - 0.4 * length)
                                           : network.vessel(0).values(place);
    largest_pressure = std::max(largest_pressure, std::abs(expected.pressure[i]));
    largest_flow = std::max(largest_flow, std::abs(expected.flow_rate[i]));
    of_pressure = std::max(of_pressure, std::abs(found.pressure - expected.pressure[i]));
    of_flow = std::max(of_flow, std::abs(found.flow - expected.flow_rate[i]));
  }
  return {of_pressure / largest_pressure, of_flow / largest_flow};
}

void check_small_waves()
{
  const Material elastic = wall_of(0., {}), kelvin_voigt = wall_of(young / 3. * 0.01, {}),
                 prony = wall_of(0., {{0.3 * young / 3., 0.02}, {0.5 * young / 3., 0.2}});
  using Type = TerminalLaw::Type;
  struct Row
  {
    const char *name;
    Case of;
    double band;
  };
  for (const Row &row : {
           Row{"elastic, closed end", {elastic, 0., true, Type::closed, false, 1200}, 1e-4},
           Row{"elastic, friction", {elastic, 0.004, true, Type::closed, false, 1200}, 1e-4},
           Row{"Kelvin-Voigt, closed end", {kelvin_voigt, 0.}, 1e-4},
           Row{"Kelvin-Voigt, flow rate, open end",
               {kelvin_voigt, 0., false, Type::pressure},
               1e-4},
           Row{"Kelvin-Voigt, friction, junction",
               {kelvin_voigt, 0.004, true, Type::closed, true},
               1e-4},
           Row{"branches, closed end", {prony, 0.}, 1e-4},
           Row{"branches, flow rate, junction", {prony, 0., false, Type::closed, true}, 1e-4},
           Row{"Kelvin-Voigt, absorbing end", {kelvin_voigt, 0., true, Type::absorbing}, 2e-3},
           Row{"branches, absorbing end", {prony, 0., true, Type::absorbing}, 1e-2},
       })
  {
    const auto [of_pressure, of_flow] = differences(row.of);
    check::absolute(std::string(row.name) + ": pressure", of_pressure, 0., row.band);
    check::absolute(std::string(row.name) + ": flow rate", of_flow, 0., row.band);
  }
  // Half the cells: four times the error.
  Case coarse{kelvin_voigt, 0.}, fine{kelvin_voigt, 0.};
  coarse.n_cells = 100;
  fine.n_cells = 200;
  check::absolute("Kelvin-Voigt: order",
                  std::log2(differences(coarse).first / differences(fine).first), 2., 0.25);
}

/// A taper with stiffness and height that vary, at rest under pressure and with flow.
void check_steady_state(const double velocity)
{
  FlowLaw law;
  law.density = density;
  law.viscosity = 0.;
  VesselDescription description;
  description.name = "taper";
  description.length = length;
  description.n_cells = 40;
  description.height_at_end = 0.3;
  auto vessel = make_vessel<SquareRootWall>(
      description, law,
      [](const double z)
      { return SquareRootWall(area * (1. - 0.4 * z), 0., density * 25. * (1. + z)); });
  vessel->set_relaxation({0.02, {{0.5, 0.05}}});
  // The steady state: one flow rate and one head, found cell by cell.
  const double flow = velocity * area, head = 4000. + 0.5 * density * velocity * velocity;
  const auto area_at = [&](const double z)
  {
    const SquareRootWall wall(area * (1. - 0.4 * z), 0., density * 25. * (1. + z));
    double found = wall.reference_area();
    for (unsigned int i = 0; i < 200; ++i)
      found = wall.area(head - density * law.gravity * 0.3 * z -
                            0.5 * density * flow * flow / (found * found),
                        found);
    return found;
  };
  std::vector<double> areas, flows(40, flow);
  for (unsigned int i = 0; i < 40; ++i)
    areas.push_back(area_at((i + 0.5) / 40.));
  TerminalLaw in, out;
  in.type = TerminalLaw::Type::flow_rate;
  in.value = [flow](double) { return flow; };
  out.type = TerminalLaw::Type::pressure;
  const double outlet = head - density * law.gravity * 0.3 -
                        0.5 * density * flow * flow / (area_at(1.) * area_at(1.));
  out.value = [outlet](double) { return outlet; };
  std::vector<Network::Edge> edges;
  edges.push_back({std::move(vessel), 0, 1});
  Network network(std::move(edges), {in, out});
  network.start_at_rest(4000.);
  network.vessel(0).set(areas, flows);
  network.advance(0.5, 0.8);
  double of_area = 0., of_flow = 0.;
  for (unsigned int i = 0; i < 40; ++i)
  {
    of_area = std::max(of_area, std::abs(network.vessel(0).areas()[i] - areas[i]));
    of_flow = std::max(of_flow, std::abs(network.vessel(0).flows()[i] - flow));
  }
  const std::string name = velocity > 0. ? "taper with flow" : "taper at rest";
  check::absolute(name + ": areas", of_area, 0., 1e-13 * area);
  check::absolute(name + ": flow rates", of_flow, 0., 1e-13 * area * 5.);
}

void check_friction_modes()
{
  const double nu = 4e-6;
  const Womersley exact(radius, density, nu * density);
  double largest = 0.;
  for (double number = 0.1; number < 300.; number *= 1.2)
  {
    const Complex s = Complex(0., nu / (radius * radius) * number * number);
    const double rate = nu / (radius * radius);
    Complex found = s + 8. * rate;
    for (const FrictionMode &mode : friction_modes)
      found += 4. * rate * mode.weight * s / (s + mode.rate * rate);
    largest = std::max(largest, std::abs(found * exact.one_minus_f10(s.imag()) / s - 1.));
  }
  check::absolute("friction modes beside Womersley's flow", largest, 0., 1.2e-5);
}

void check_materials()
{
  Material wall = wall_of(100., {{0.25 * young / 3., 0.1}});
  const WallMaterial found = WallMaterial::of(wall);
  check::relative("material: Young's modulus", found.youngs_modulus, young, 1e-14);
  check::relative("material: damping time", found.relaxation.damping_time, 300. / young, 1e-14);
  check::relative("material: share", found.relaxation.branches.at(0).share, 0.25, 1e-14);
  Material compressible = wall_of(0., {});
  // mu = Y/3 and K = Y: Poisson's ratio (3 K - 2 mu)/(2 (3 K + mu)) = 0.35.
  compressible.compression = Compression::elastic(1. / young);
  check::relative("material: Poisson's ratio", WallMaterial::of(compressible).poissons_ratio, 0.35,
                  1e-14);
  wall.compression = Compression::elastic(1. / young);
  check::throws<std::domain_error>(
      "material whose Poisson's ratio depends on time", [&]() { WallMaterial::of(wall); },
      "Poisson's ratio that depends on time");
  wall.shear.branches.erase(wall.shear.branches.begin());
  check::throws<std::domain_error>(
      "material without a spring", [&]() { WallMaterial::of(wall); }, "no spring");
  check::throws<std::domain_error>(
      "liquid", []() { WallMaterial::of(Material()); }, "is a liquid");
}
} // namespace

UNIT_TEST(vessel_memory)
{
  check_friction_modes();
  check_materials();
  check_small_waves();
  check_steady_state(0.);
  check_steady_state(0.4);
}
} // namespace test_of_vessel_memory
