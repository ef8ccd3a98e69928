// Elements without a length against exact answers: a compliance that empties, an inertance that
// swings, a valve with an inertance, pulses at a valve between vessels, a windkessel of elements
// beside the terminal; volume, work, and elements whose pressure follows from nothing.

#include <continua/base/input_error.h>
#include <continua/network/network.h>
#include <continua/network/square_root_wall.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../unit_test.h"

namespace test_of_circuit
{
using namespace Continua;

namespace
{
using Type = ElementLaw::Type;

ElementLaw between(const Type type,
                   const unsigned int from,
                   const unsigned int to,
                   const double resistance,
                   const double inertance = 0.)
{
  ElementLaw law;
  law.type = type;
  law.from = from;
  law.to = to;
  law.resistance = resistance;
  law.inertance = inertance;
  return law;
}

ElementLaw compliance_at(const unsigned int node, const double compliance, const double pressure)
{
  ElementLaw law;
  law.type = Type::compliance;
  law.from = node;
  law.compliance = compliance;
  law.initial_volume = compliance * pressure;
  return law;
}

/// What `value` has at the end, with a step and with half of it; checks its error and its order.
template <typename Make, typename Value>
void check_order(const std::string &name,
                 const Make &make,
                 const Value &value,
                 const double end,
                 const double exact,
                 const double scale,
                 const double band)
{
  double errors[2];
  for (const unsigned int i : {0u, 1u})
  {
    Network network = make();
    network.advance(end, 1., end / (100u << i));
    errors[i] = std::abs(value(network) - exact) / scale;
  }
  check::absolute(name + ": error", errors[0], 0., band);
  check::absolute(name + ": order", std::log2(errors[0] / errors[1]), 2., 0.1);
}

/// A compliance of 1e-8 that empties through 2e7: the time constant is 0.2 s.
void emptying()
{
  Circuit::Description circuit;
  circuit.elements = {compliance_at(0, 1e-8, 1e4), between(Type::resistance, 0, 1, 2e7)};
  circuit.pressures = {{1, [](double) { return 0.; }}};
  check_order(
      "a compliance that empties",
      [&]() {
        return Network({}, {2, TerminalLaw()}, circuit);
      },
      [](const Network &network) { return network.circuit().values(0).pressure; }, 0.3,
      1e4 * std::exp(-1.5), 1e4, 1e-5);
  Network network({}, {2, TerminalLaw()}, circuit);
  const double before = network.volume();
  network.advance(10., 1., 1.); // steps of five time constants
  check::absolute("steps of five time constants: what is left of the pressure",
                  network.circuit().values(0).pressure / 1e4, 0., 1e-5);
  check::absolute("volume", (network.volume() - before - network.inflow()) / before, 0., 1e-14);
}

/// L and C without a resistance: the angular frequency is 1/sqrt(L C) = 100/s.
void swinging()
{
  Circuit::Description circuit;
  circuit.elements = {compliance_at(0, 1e-8, 1e3), between(Type::resistance, 0, 1, 0., 1e4)};
  circuit.pressures = {{1, [](double) { return 0.; }}};
  check_order(
      "an inertance that swings",
      [&]() {
        return Network({}, {2, TerminalLaw()}, circuit);
      },
      [](const Network &network) { return network.circuit().values(1).flow; }, 0.04,
      1e3 * std::sqrt(1e-8 / 1e4) * std::sin(4.), 1e-3, 1e-2);
}

/// L dQ/dt = P cos(w t) through a valve: Q = P/(w L) sin(w t) until pi/w; nothing until 3 pi/(2 w);
/// then P/(w L) (1 + sin(w t)).
void valve_with_inertance()
{
  const double w = 10., largest = 1e3 / (w * 1e5);
  Circuit::Description circuit;
  circuit.elements = {between(Type::valve, 0, 1, 0., 1e5)};
  circuit.pressures = {{0, [w](const double t) { return 1e3 * std::cos(w * t); }},
                       {1, [](double) { return 0.; }}};
  Network network({}, {2, TerminalLaw()}, circuit);
  network.start_at_rest(0.);
  const auto flow_at = [&](const double phase)
  {
    network.advance(phase / w, 1., 1e-4);
    return network.circuit().values(0).flow / largest;
  };
  check::absolute("valve with inertance: open", flow_at(2.), std::sin(2.), 1e-5);
  check::absolute("valve with inertance: closed", flow_at(4.), 0., 1e-8);
  check::absolute("valve with inertance: opens again", flow_at(6.), 1. + std::sin(6.), 1e-3);
}

std::unique_ptr<Vessel> tube(const std::string &name)
{
  FlowLaw law;
  law.density = 1000.;
  law.viscosity = 0.;
  VesselDescription description;
  description.name = name;
  description.length = 1.;
  description.n_cells = 400;
  return make_vessel<SquareRootWall>(description, law,
                                     [](double) { return SquareRootWall(1e-4, 0., 1000. * 25.); });
}

/// Two vessels of the impedance Z = rho c/A = 5e7 Pa s/m^3 with an element of 1e8 between them: of
/// a small pulse 2 Z/(2 Z + R) = 1/2 passes, and R/(2 Z + R) = 1/2 returns. Nothing of a fall of
/// the pressure passes a valve, and all of it returns.
void pulse_at(const Type type, const double sign, const double passes, const double returns)
{
  std::vector<Network::Edge> edges;
  edges.push_back({tube("first"), 0, 1});
  edges.push_back({tube("second"), 2, 3});
  std::vector<TerminalLaw> terminals(4);
  terminals[0].type = TerminalLaw::Type::flow_rate;
  terminals[0].value = [sign](const double t)
  { return t < 0.08 ? sign * 1e-8 * std::pow(std::sin(M_PI * t / 0.08), 2) : 0.; };
  terminals[3].type = TerminalLaw::Type::absorbing;
  Circuit::Description circuit;
  circuit.elements = {between(type, 1, 2, 1e8)};
  Network network(std::move(edges), terminals, circuit);
  network.start_at_rest(0.);
  const double before = network.volume(), height = 1e-8 * 5e7;
  double back = 0., through = 0.;
  for (unsigned int i = 1; i <= 200; ++i)
  {
    network.advance(i * 2e-3, 0.8);
    if (network.time() > 0.24) // the first pulse has left the middle
      back = std::max(back, sign * network.vessel(0).values(0.5).pressure / height);
    through = std::max(through, std::abs(network.vessel(1).values(0.2).pressure) / height);
  }
  const std::string name = std::string(type == Type::valve ? "a valve" : "a resistance") +
                           (sign > 0. ? ", a rise: " : ", a fall: ");
  check::absolute(name + "passes", through, passes, 0.005);
  check::absolute(name + "returns", back, returns, 0.005);
  check::absolute(name + "volume", (network.volume() - before - network.inflow()) / before, 0.,
                  1e-13);
}

/// The same windkessel of elements and as a terminal.
void windkessel()
{
  double flows[2], pressures[2];
  for (const bool of_elements : {false, true})
  {
    std::vector<Network::Edge> edges;
    edges.push_back({tube("tube"), 0, 1});
    std::vector<TerminalLaw> terminals(2);
    terminals[0].type = TerminalLaw::Type::flow_rate;
    terminals[0].value = [](const double t) { return 1e-6 * std::pow(std::sin(5. * t), 2); };
    terminals[1].type = TerminalLaw::Type::windkessel;
    terminals[1].resistance = 5e7;
    terminals[1].distal_resistance = 1e9;
    terminals[1].compliance = 1e-10;
    Circuit::Description circuit;
    if (of_elements)
    {
      circuit.elements = {compliance_at(2, 1e-10, 0.), between(Type::resistance, 1, 2, 5e7),
                          between(Type::resistance, 2, 3, 1e9)};
      circuit.pressures = {{3, [](double) { return 0.; }}};
    }
    Network network(std::move(edges), terminals, circuit);
    network.start_at_rest(0.);
    network.advance(0.9, 0.8);
    const Vessel::Values values = network.vessel(0).values(1.);
    flows[of_elements ? 1 : 0] = values.flow;
    pressures[of_elements ? 1 : 0] = values.pressure;
  }
  check::relative("windkessel of elements: flow rate", flows[1], flows[0], 1e-5);
  check::relative("windkessel of elements: pressure", pressures[1], pressures[0], 1e-5);
}

/// A chamber of constant elastance that empties: its work is the energy that it loses.
void work()
{
  Circuit::Description circuit;
  ElementLaw chamber;
  chamber.type = Type::chamber;
  chamber.from = 0;
  chamber.elastance = [](double) { return 1e8; };
  chamber.unloaded_volume = 1e-5;
  chamber.initial_volume = 1.1e-4;
  circuit.elements = {chamber, between(Type::valve, 0, 1, 2e7), between(Type::valve, 2, 0, 1e6)};
  circuit.pressures = {{1, [](double) { return 0.; }}, {2, [](double) { return -1e6; }}};
  Network network({}, {3, TerminalLaw()}, circuit);
  network.start_at_rest(0.);
  network.advance(0.2, 1., 1e-3);
  const Circuit::Values values = network.circuit().values(0);
  check::relative("a chamber that empties: volume", values.volume, 1e-5 + 1e-4 * std::exp(-1.),
                  1e-5);
  check::relative("a chamber that empties: work", values.work,
                  0.5 * 1e8 * 1e-8 * (1. - std::exp(-2.)), 1e-5);
  // Forty time constants: what is left of the pressure is less than the round-off of the volume.
  circuit.elements = {chamber, between(Type::resistance, 0, 1, 2e7)};
  circuit.pressures.pop_back();
  Network network_at_last({}, {2, TerminalLaw()}, circuit);
  network_at_last.start_at_rest(0.);
  network_at_last.advance(8., 1., 1e-2);
  check::absolute("a chamber that empties: at last", network_at_last.circuit().values(0).pressure,
                  0., 1e-6);
}

void without_pressure()
{
  Circuit::Description circuit;
  circuit.elements = {between(Type::resistance, 0, 1, 1., 1.), between(Type::valve, 1, 2, 1., 1.)};
  circuit.elements[1].name = "second";
  circuit.elements[0].name = "first";
  circuit.pressures = {{0, [](double) { return 0.; }}, {2, [](double) { return 0.; }}};
  check::equal("a node between two inertances", Circuit(circuit, {}).element_without_pressure(),
               "first");
  circuit.elements[1].inertance = 0.;
  check::equal("a node beside a resistance", Circuit(circuit, {}).element_without_pressure(), "");
}
} // namespace

UNIT_TEST(circuit)
{
  emptying();
  swinging();
  valve_with_inertance();
  pulse_at(Type::resistance, 1., 0.5, 0.5);
  pulse_at(Type::valve, 1., 0.5, 0.5);
  pulse_at(Type::valve, -1., 0., 1.);
  windkessel();
  work();
  without_pressure();
}
} // namespace test_of_circuit
