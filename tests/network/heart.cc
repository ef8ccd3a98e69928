// A chamber of the heart that empties through its valve, that fills, and whose valve lets nothing
// back, against exponentials; a closed valve against a closed end.

#include <continua/network/network.h>
#include <continua/network/square_root_wall.h>

#include <cmath>

#include "../unit_test.h"

namespace test_of_heart
{
using namespace Continua;

namespace
{
constexpr double elastance = 1e8, valve = 2e6, filling = 5e6; // Pa/m^3, Pa s/m^3

/// A stiff, short tube between the heart and a resistance [Pa s/m^3] with a pressure behind [Pa].
Network network_of(const Heart::Law &heart, const double resistance, const double behind)
{
  FlowLaw law;
  law.viscosity = 0.;
  VesselDescription description;
  description.name = "tube";
  description.length = 0.01;
  description.n_cells = 4;
  std::vector<Network::Edge> edges;
  edges.push_back({make_vessel<SquareRootWall>(
                       description, law, [](double) { return SquareRootWall(5e-3, 0., 1e7); }),
                   0, 1});
  TerminalLaw in, out;
  in.type = TerminalLaw::Type::heart;
  in.heart = heart;
  out.type = TerminalLaw::Type::resistance;
  out.resistance = resistance;
  out.pressure_behind = behind;
  Network network(std::move(edges), {in, out});
  network.start_at_rest(behind);
  return network;
}

double flow_at_end(const Network &network)
{
  return network.vessel(0).end_state(Vessel::End::end).flow;
}

/// dV/dt = -E V/(R_valve + R): the flow rate falls as an exponential. The tube gives way by 5e-4 of
/// what the chamber does, and its inertia has 0.1 ms.
void check_emptying()
{
  const double resistance = 18e6, time = (valve + resistance) / elastance; // 0.2 s
  const Heart::Law heart{[](double) { return elastance; }, 1e-5, 1.1e-4, valve, -1e6, filling};
  Network network = network_of(heart, resistance, 0.);
  network.advance(0.1, 0.8);
  const double first = flow_at_end(network);
  network.advance(0.3, 0.8);
  check::relative("emptying: flow rate", first, 1e4 / (valve + resistance) * std::exp(-0.1 / time),
                  2e-3);
  check::relative("emptying: time constant", 0.2 / std::log(first / flow_at_end(network)), time,
                  1e-3);
}

/// The chamber fills through a resistance up to P/E, with the time constant R/E, while the other
/// valve is held closed by the pressure behind it; then it is emptied at once.
void check_filling()
{
  const double pressure = 2000., time = filling / elastance; // 50 ms
  Heart chamber({[](double) { return elastance; }, 1e-5, 1.2e-5, valve, pressure, filling});
  constexpr double step = 1e-3;
  for (unsigned int i = 0; i < 60; ++i)
  {
    chamber.take(false, i * step, step, 0.);
    chamber.take(true, i * step, step, 0.);
    chamber.end_step(i * step, step);
  }
  const double full = pressure / elastance,
               exact = 1e-5 + full + (2e-6 - full) * std::exp(-0.06 / time);
  check::relative("filling: volume", chamber.volume(), exact, 1e-4);

  // Nothing flows back through the valve.
  Network network = network_of(
      {[](double) { return elastance; }, 1e-5, 1.2e-5, valve, pressure, filling}, 18e6, 5000.);
  network.advance(0.1, 0.8);
  check::absolute("a pressure that holds the valve closed: flow rate", flow_at_end(network), 0.,
                  1e-14);
  check::absolute("a pressure that holds the valve closed: inflow", network.inflow(), 0., 1e-16);
}

/// Beats eject liquid, none flows back, and what has come into the tube is there.
void check_beats()
{
  const auto beating = [](const double time)
  {
    const double phase = time - std::floor(time), sine = std::sin(FlowLaw::pi * phase / 0.3);
    return 1e7 + (phase < 0.3 ? 3e8 * sine * sine : 0.);
  };
  Network network = network_of({beating, 1e-5, 1.2e-4, valve, 1000., filling}, 1e8, 0.);
  network.advance(1., 0.8);
  const double volume = network.volume() - network.inflow();
  double least = 0., sum = 0.;
  for (unsigned int i = 1; i <= 500; ++i)
  {
    network.advance(1. + i / 500., 0.8);
    const double flow = network.vessel(0).end_state(Vessel::End::start).flow;
    least = std::fmin(least, flow);
    sum += flow / 500.;
  }
  check::is_true("beats: something is ejected", sum > 1e-5);
  check::absolute("beats: nothing flows back", least, 0., 1e-12);
  check::relative("beats: volume of the liquid", network.volume() - network.inflow(), volume,
                  1e-13);
}
/// While a pulse goes to and fro in a tube whose wall relaxes, a heart whose valve the pressure
/// holds closed does as a closed end.
void check_closed_valve()
{
  const auto network = [](const TerminalLaw &at_start)
  {
    VesselDescription description;
    description.name = "tube";
    description.length = 1.;
    description.n_cells = 100;
    std::vector<Network::Edge> edges;
    edges.push_back(
        {make_vessel<SquareRootWall>(description, FlowLaw(),
                                     [](double) { return SquareRootWall(3e-4, 0., 25e3); }),
         0, 1});
    edges.back().vessel->set_relaxation({0., {{0.5, 0.05}}});
    TerminalLaw pulse;
    pulse.type = TerminalLaw::Type::flow_rate;
    pulse.value = [](const double time)
    {
      const double sine = std::sin(FlowLaw::pi * time / 0.1);
      return time < 0.1 ? 1e-5 * sine * sine : 0.;
    };
    Network result(std::move(edges), {at_start, pulse});
    result.start_at_rest(0.);
    return result;
  };
  TerminalLaw heart;
  heart.type = TerminalLaw::Type::heart;
  // -1 MPa in the chamber, and nothing fills it.
  heart.heart = {[](double) { return elastance; }, 0.01, 0., valve, -2e6, filling};
  Network with_valve = network(heart), closed = network(TerminalLaw());
  Vessel::Values largest = {}, difference = {};
  for (unsigned int i = 1; i <= 50; ++i)
  {
    with_valve.advance(0.02 * i, 0.8);
    closed.advance(0.02 * i, 0.8);
    const Vessel::Values values = with_valve.vessel(0).values(0.5),
                         exact = closed.vessel(0).values(0.5);
    const auto compare = [&](double Vessel::Values::*const field)
    {
      largest.*field = std::fmax(largest.*field, std::abs(exact.*field));
      difference.*field = std::fmax(difference.*field, std::abs(values.*field - exact.*field));
    };
    compare(&Vessel::Values::pressure);
    compare(&Vessel::Values::flow);
  }
  check::absolute("closed valve, wall that relaxes: pressure",
                  difference.pressure / largest.pressure, 0., 1e-12);
  check::absolute("closed valve, wall that relaxes: flow rate", difference.flow / largest.flow, 0.,
                  1e-12);
}
} // namespace

UNIT_TEST(heart)
{
  check_emptying();
  check_filling();
  check_beats();
  check_closed_valve();
}
} // namespace test_of_heart
