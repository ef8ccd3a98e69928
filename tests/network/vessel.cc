// The scheme along one vessel against exact solutions: a simple wave by its characteristics, a
// Riemann problem, states at rest and with flow on a taper, the flow of Poiseuille.

#include <continua/base/input_error.h>
#include <continua/network/neo_hookean_wall.h>
#include <continua/network/network.h>
#include <continua/network/square_root_wall.h>

#include <algorithm>
#include <cmath>

#include "../unit_test.h"

namespace test_of_vessel
{
using namespace Continua;

namespace
{
constexpr double start_area = 3e-4, start_speed = 5., density = 1000.; // m^2, m/s, kg/m^3

FlowLaw inviscid()
{
  FlowLaw law;
  law.density = density;
  law.viscosity = 0.;
  return law;
}

/// c of the square-root law: it goes with the fourth root of the area.
double speed_at(const double area)
{
  return start_speed * std::pow(area / start_area, 0.25);
}

TerminalLaw terminal(const TerminalLaw::Type type, const double value = 0.)
{
  TerminalLaw law;
  law.type = type;
  law.value = [value](double) { return value; };
  return law;
}

template <typename Wall>
Network one_vessel(const VesselDescription &description,
                   const FlowLaw &law,
                   const std::function<Wall(double)> &wall,
                   const TerminalLaw &start,
                   const TerminalLaw &end)
{
  std::vector<Network::Edge> edges;
  edges.push_back({make_vessel<Wall>(description, law, wall), 0, 1});
  return Network(std::move(edges), {start, end});
}

Network uniform_tube(const unsigned int n_cells, const TerminalLaw::Type ends)
{
  VesselDescription description;
  description.name = "tube";
  description.length = 1.;
  description.n_cells = n_cells;
  Network network = one_vessel<SquareRootWall>(
      description, inviscid(),
      [](double) { return SquareRootWall(start_area, 0., density * start_speed * start_speed); },
      terminal(ends), terminal(ends));
  network.start_at_rest(0.);
  return network;
}

/// The area of the wave at the start, 10 % more at its peak.
double area_at_start(const double z)
{
  const double distance = (z - 0.35) / 0.12;
  return start_area * (1. + 0.1 * std::exp(-distance * distance));
}

/// The relative error, in the mean, of a wave that has run for 0.04 s and has not broken.
double error_of_simple_wave(const unsigned int n_cells)
{
  Network network = uniform_tube(n_cells, TerminalLaw::Type::absorbing);
  std::vector<double> areas, flows;
  for (unsigned int i = 0; i < n_cells; ++i)
  {
    areas.push_back(area_at_start((i + 0.5) / n_cells));
    flows.push_back(areas[i] * 4. * (speed_at(areas[i]) - start_speed));
  }
  network.vessel(0).set(areas, flows);
  const double time = 0.04, volume = network.volume();
  network.advance(time, 0.8);
  check::absolute("simple wave: volume", network.volume() - volume - network.inflow(), 0.,
                  1e-13 * volume);
  double error = 0., sum = 0.;
  for (unsigned int i = 0; i < n_cells; ++i)
  {
    // Along a characteristic the area stays: it runs with U + c = 5 c - 4 c0.
    const double z = (i + 0.5) / n_cells;
    double origin = z - time * start_speed;
    for (unsigned int k = 0; k < 100; ++k)
      origin = z - time * (5. * speed_at(area_at_start(origin)) - 4. * start_speed);
    const double exact = area_at_start(origin);
    error += std::abs(network.vessel(0).areas()[i] - exact);
    sum += exact - start_area;
  }
  return error / sum;
}

/// `ratio` times the area on the left: a rarefaction to the left, a shock to the right.
/// `band` is that of the area between the waves.
void check_riemann_problem(const double ratio,
                           const double time,
                           const double band,
                           const double band_of_speed)
{
  constexpr unsigned int n_cells = 400;
  const std::string name = "Riemann problem of " + std::to_string(ratio) + ": ";
  const double left = ratio * start_area, right = start_area;
  Network network = uniform_tube(n_cells, TerminalLaw::Type::closed);
  std::vector<double> areas(n_cells, right);
  std::fill(areas.begin(), areas.begin() + n_cells / 2, left);
  network.vessel(0).set(areas, std::vector<double>(n_cells, 0.));
  network.advance(time, 0.8);

  // The velocities behind the rarefaction and the shock are equal. The momentum flux is A U^2 + k
  // A^(3/2).
  const double k = 2. * start_speed * start_speed / (3. * std::sqrt(start_area));
  const auto behind_rarefaction = [&](const double area)
  { return 4. * (speed_at(left) - speed_at(area)); };
  const auto behind_shock = [&](const double area)
  {
    return std::sqrt(k * (std::pow(area, 1.5) - std::pow(right, 1.5)) * (area - right) /
                     (area * right));
  };
  double low = right, high = left;
  for (unsigned int i = 0; i < 100; ++i)
  {
    const double middle = 0.5 * (low + high);
    (behind_rarefaction(middle) > behind_shock(middle) ? low : high) = middle;
  }
  const double star = low, velocity = behind_shock(star),
               speed = star * velocity / (star - right); // by the conservation of mass
  const auto &found = network.vessel(0).areas(), &flows = network.vessel(0).flows();
  const auto cell_at = [&](const double of_speed)
  { return static_cast<unsigned int>(n_cells * (0.5 + of_speed * time)); };
  const unsigned int between = cell_at(0.5 * (velocity - speed_at(star) + speed));
  check::relative(name + "area between the waves", found[between], star, band);
  check::relative(name + "velocity between the waves", flows[between] / found[between], velocity,
                  10. * band);
  // In the fan U - c = z/t, U + 4 c = 4 c of the left state.
  const double fan = -0.5 * (speed_at(left) - velocity + speed_at(star));
  const unsigned int in_fan = cell_at(fan);
  const double z_over_t = ((in_fan + 0.5) / n_cells - 0.5) / time;
  check::relative(name + "area in the rarefaction", found[in_fan],
                  start_area * std::pow((4. * speed_at(left) - z_over_t) / (5. * start_speed), 4.),
                  100. * band);
  // The liquid on the right of the middle gives the place of the shock to a part of a cell.
  double behind = 0.;
  for (unsigned int i = between; i < n_cells; ++i)
    behind += (found[i] - right) / (star - right);
  check::relative(name + "speed of the shock", ((between + behind) / n_cells - 0.5) / time, speed,
                  band_of_speed);
  // No wave has come to the ends, whose pressures alone act on the liquid.
  double momentum = 0.;
  for (const double flow : flows)
    momentum += flow / n_cells;
  check::relative(name + "momentum", momentum,
                  k * (std::pow(left, 1.5) - std::pow(right, 1.5)) * time, 0.2 * band);
}

/// Small pulses up and down a flow with alpha 4/3: alpha U +- sqrt(c^2 + alpha (alpha - 1) U^2).
void check_speeds_on_a_flow()
{
  constexpr unsigned int n_cells = 400;
  constexpr double alpha = 4. / 3., velocity = 0.3 * start_speed, time = 0.05, begin = 0.45;
  VesselDescription description;
  description.name = "tube";
  description.length = 1.;
  description.n_cells = n_cells;
  FlowLaw law = inviscid();
  law.momentum_correction = alpha;
  Network network = one_vessel<SquareRootWall>(
      description, law,
      [](double) { return SquareRootWall(start_area, 0., density * start_speed * start_speed); },
      terminal(TerminalLaw::Type::flow_rate, velocity * start_area),
      terminal(TerminalLaw::Type::pressure, 0.));
  std::vector<double> areas;
  for (unsigned int i = 0; i < n_cells; ++i)
  {
    const double distance = ((i + 0.5) / n_cells - begin) / 0.03;
    areas.push_back(start_area * (1. + 1e-6 * std::exp(-distance * distance)));
  }
  network.vessel(0).set(areas, std::vector<double>(n_cells, velocity * start_area));
  network.advance(time, 0.8);
  const double middle = begin + alpha * velocity * time,
               relative = std::sqrt(start_speed * start_speed +
                                    alpha * (alpha - 1.) * velocity * velocity);
  for (const bool downwards : {false, true})
  {
    double sum = 0., moment = 0.;
    for (unsigned int i = 0; i < n_cells; ++i)
    {
      const double z = (i + 0.5) / n_cells, excess = network.vessel(0).areas()[i] / start_area - 1.;
      if ((z > middle) == downwards)
      {
        sum += excess;
        moment += z * excess;
      }
    }
    check::relative(
        downwards ? "speed of a wave with the flow" : "speed of a wave against the flow",
        (moment / sum - begin) / time, alpha * velocity + (downwards ? relative : -relative), 2e-3);
  }
}

/// A pressure that is set at once at the start: a shock whose liquid is three quarters as fast as
/// the wave behind it.
void check_sudden_pressure()
{
  VesselDescription description;
  description.name = "tube";
  description.length = 0.5;
  description.n_cells = 200;
  constexpr double area = 3e-4, speed = 2.58, pressure = 7000.;
  Network network = one_vessel<SquareRootWall>(
      description, inviscid(),
      [](double) { return SquareRootWall(area, 0., density * speed * speed); },
      terminal(TerminalLaw::Type::pressure, pressure), terminal(TerminalLaw::Type::absorbing));
  network.start_at_rest(0.);
  network.advance(0.05, 0.8);
  const double k = 2. * speed * speed / (3. * std::sqrt(area)),
               root = 1. + pressure / (2. * density * speed * speed), behind = area * root * root,
               velocity = std::sqrt(k * (std::pow(behind, 1.5) - std::pow(area, 1.5)) *
                                    (behind - area) / (behind * area));
  const Vessel::Values values = network.vessel(0).values(0.05);
  check::relative("sudden pressure: area behind the shock", values.area, behind, 0.01);
  check::relative("sudden pressure: velocity behind the shock", values.flow / values.area, velocity,
                  0.01);
}

/// A taper whose stiffness varies, too, and which rises: at rest, and with a steady flow.
template <typename Wall>
void check_steady_state(const std::string &name,
                        const std::function<Wall(double)> &wall,
                        const double velocity,
                        const double alpha)
{
  constexpr unsigned int n_cells = 40;
  VesselDescription description;
  description.name = "taper";
  description.length = 1.;
  description.n_cells = n_cells;
  description.height_at_end = 0.2;
  FlowLaw law = inviscid();
  law.momentum_correction = alpha;
  const double head = 3000., flow = velocity * 2e-4;
  const auto area_at = [&](const double z)
  {
    const Wall section = wall(z);
    const double wanted = head - density * law.gravity * 0.2 * z;
    double area = section.area(wanted, section.reference_area());
    for (unsigned int i = 0; i < 50; ++i)
    {
      const double factor = density * alpha * flow * flow;
      area -= (section.pressure(area) + 0.5 * factor / (area * area) - wanted) /
              (section.stiffness(area) - factor / (area * area * area));
    }
    return area;
  };
  Network network =
      one_vessel<Wall>(description, law, wall, terminal(TerminalLaw::Type::flow_rate, flow),
                       terminal(TerminalLaw::Type::pressure, wall(1.).pressure(area_at(1.))));
  std::vector<double> areas;
  for (unsigned int i = 0; i < n_cells; ++i)
    areas.push_back(area_at((i + 0.5) / n_cells));
  network.vessel(0).set(areas, std::vector<double>(n_cells, flow));
  network.advance(0.5, 0.8);
  double of_area = 0., of_flow = 0.;
  for (unsigned int i = 0; i < n_cells; ++i)
  {
    of_area = std::fmax(of_area, std::abs(network.vessel(0).areas()[i] / areas[i] - 1.));
    of_flow = std::fmax(of_flow, std::abs(network.vessel(0).flows()[i] - flow));
  }
  check::absolute(name + ": areas", of_area, 0., 1e-13);
  check::absolute(name + ": flow rates", of_flow, 0., 1e-13 * start_speed * start_area);
}

/// Friction: the pressure falls along the tube as Poiseuille has it.
void check_friction()
{
  VesselDescription description;
  description.name = "tube";
  description.length = 0.2;
  description.n_cells = 20;
  FlowLaw law;
  const double radius = 0.002, flow = 1e-6;
  Network network = one_vessel<SquareRootWall>(
      description, law,
      [&](double) { return SquareRootWall(FlowLaw::pi * radius * radius, 0., 1e6); },
      terminal(TerminalLaw::Type::flow_rate, flow), terminal(TerminalLaw::Type::pressure, 0.));
  network.start_at_rest(0.);
  network.advance(3., 0.9);
  check::relative("friction of Poiseuille", network.vessel(0).values(0.).pressure,
                  8. * law.viscosity * 0.2 * flow / (FlowLaw::pi * std::pow(radius, 4.)), 1e-3);
}
} // namespace

UNIT_TEST(vessel)
{
  const double coarse = error_of_simple_wave(160), fine = error_of_simple_wave(320);
  check::absolute("simple wave: order", std::log2(coarse / fine), 2., 0.1);
  check::absolute("simple wave: error", fine, 0., 2e-3);
  check_riemann_problem(2., 0.06, 1e-5, 2e-4);
  check_riemann_problem(4., 0.05, 1e-4, 5e-4);
  check_speeds_on_a_flow();
  check_sudden_pressure();

  const std::function<SquareRootWall(double)> root = [](const double z)
  {
    const double radius = 0.01 - 0.004 * z;
    return SquareRootWall(FlowLaw::pi * radius * radius, 0., density * 25. * (1. + z));
  };
  const std::function<NeoHookeanWall(double)> neo_hookean = [](const double z)
  {
    const double radius = 0.01 - 0.004 * z, thickness = 0.002 - 0.001 * z;
    return NeoHookeanWall(FlowLaw::pi * radius * radius,
                          FlowLaw::pi * thickness * (2. * radius + thickness), 0., 1e5 * (1. + z));
  };
  for (const double alpha : {1., 4. / 3.})
  {
    const std::string of_alpha = ", alpha " + std::to_string(alpha);
    check_steady_state("taper at rest" + of_alpha, root, 0., alpha);
    check_steady_state("taper with flow" + of_alpha, root, 0.4, alpha);
    check_steady_state("neo-Hookean taper with flow" + of_alpha, neo_hookean, 0.4, alpha);
  }
  check_friction();

  // Liquid is drawn off through both ends until none is left.
  VesselDescription description;
  description.name = "tube";
  description.length = 1.;
  description.n_cells = 20;
  Network network = one_vessel<SquareRootWall>(
      description, inviscid(),
      [](double) { return SquareRootWall(start_area, 0., density * start_speed * start_speed); },
      terminal(TerminalLaw::Type::flow_rate, -4e-4), terminal(TerminalLaw::Type::flow_rate, -4e-4));
  network.start_at_rest(0.);
  check::throws<StepFailure>(
      "a flow that closes the tube", [&]() { network.advance(1., 0.8); },
      "at 0\\.[0-9]+ s.* the vessel 'tube'");
}
} // namespace test_of_vessel
