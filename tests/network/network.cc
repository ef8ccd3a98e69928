// What stands at the ends of vessels, and vessels that meet, against reflection coefficients of
// small waves, a windkessel in closed form, and a tube in one piece.

#include <continua/base/input_error.h>
#include <continua/network/network.h>
#include <continua/network/square_root_wall.h>

#include <algorithm>
#include <cmath>

#include "../unit_test.h"

namespace test_of_network
{
using namespace Continua;

namespace
{
constexpr double density = 1000.; // kg/m^3

struct Tube
{
  unsigned int from, to;
  double length, area, speed; ///< [m], [m^2], [m/s]
  unsigned int n_cells;
};

Network network_of(const std::vector<Tube> &tubes,
                   const std::vector<TerminalLaw> &terminals,
                   const double alpha = 1.)
{
  FlowLaw law;
  law.momentum_correction = alpha;
  law.density = density;
  law.viscosity = 0.;
  std::vector<Network::Edge> edges;
  for (const Tube &tube : tubes)
  {
    VesselDescription description;
    description.name = "tube";
    description.length = tube.length;
    description.n_cells = tube.n_cells;
    const auto wall = [tube](double)
    { return SquareRootWall(tube.area, 0., density * tube.speed * tube.speed); };
    edges.push_back({make_vessel<SquareRootWall>(description, law, wall), tube.from, tube.to});
  }
  Network network(std::move(edges), terminals);
  network.start_at_rest(0.);
  return network;
}

/// A pulse of the flow rate, of this height and length.
TerminalLaw pulse(const double height, const double length)
{
  TerminalLaw law;
  law.type = TerminalLaw::Type::flow_rate;
  law.value = [=](const double time)
  {
    const double sine = std::sin(FlowLaw::pi * time / length);
    return time < length ? height * sine * sine : 0.;
  };
  return law;
}

TerminalLaw end_of(const TerminalLaw::Type type)
{
  TerminalLaw law;
  law.type = type;
  return law;
}

double impedance(const Tube &tube)
{
  return density * tube.speed / tube.area;
}

/// The largest and smallest pressure in the middle of a vessel after the pulse has gone by.
double
extreme_after(Network &network, const unsigned int vessel, const double begin, const double end)
{
  double extreme = 0.;
  network.advance(begin, 0.9);
  for (unsigned int i = 1; i <= 200; ++i)
  {
    network.advance(begin + i * (end - begin) / 200., 0.9);
    const double pressure =
        network.vessel(vessel).values(0.5 * network.vessel(vessel).length()).pressure;
    if (std::abs(pressure) > std::abs(extreme))
      extreme = pressure;
  }
  return extreme;
}

/// The velocity behind a wave, dU/dA = ((alpha - 1) U +- sqrt(c^2 + alpha (alpha - 1) U^2))/A with
/// c of the square-root law, by 20000 steps of the midpoint rule.
double behind_wave(const Tube &tube,
                   const double alpha,
                   const double direction,
                   const Vessel::State &from,
                   const double to)
{
  constexpr unsigned int n_steps = 20000;
  const double step = (to - from.area) / n_steps;
  const auto rate = [&](const double area, const double velocity)
  {
    const double speed = tube.speed * std::pow(area / tube.area, 0.25);
    return ((alpha - 1.) * velocity +
            direction * std::sqrt(speed * speed + alpha * (alpha - 1.) * velocity * velocity)) /
           area;
  };
  double velocity = from.flow / from.area;
  for (unsigned int i = 0; i < n_steps; ++i)
  {
    const double area = from.area + i * step;
    velocity += step * rate(area + 0.5 * step, velocity + 0.5 * step * rate(area, velocity));
  }
  return velocity;
}

/// The waves of an end, into the vessel and out of it, in liquid that flows.
void check_end_waves()
{
  const Tube tube = {0, 1, 1., 3e-4, 5., 10};
  const Vessel::State inside = {3.2e-4, 5e-4}; // a third as fast as the wave
  const double area = 1.1 * inside.area;
  for (const double alpha : {1., 4. / 3.})
  {
    Network network = network_of(
        {tube}, {end_of(TerminalLaw::Type::closed), end_of(TerminalLaw::Type::closed)}, alpha);
    Vessel &vessel = network.vessel(0);
    vessel.set(std::vector<double>(tube.n_cells, inside.area),
               std::vector<double>(tube.n_cells, inside.flow));
    check::is_true("wave of an end: state inside", vessel.reconstruct());
    for (const Vessel::End end : {Vessel::End::start, Vessel::End::end})
    {
      EndWave wave(vessel, end);
      wave.begin();
      const std::string name = std::string("wave of the ") +
                               (end == Vessel::End::end ? "end" : "start") + ", alpha " +
                               std::to_string(alpha) + ": ";
      check::relative(name + "into the vessel", wave.at_area(area).velocity,
                      behind_wave(tube, alpha, -wave.direction(), inside, area), 1e-5);
      check::relative(name + "out of it", wave.leaving(tube.area, area).first,
                      behind_wave(tube, alpha, wave.direction(), {tube.area, 0.}, area), 1e-7);
    }
  }
}

void check_reflections()
{
  const Tube tube = {0, 1, 1., 3e-4, 5., 100};
  const double small = 1e-9, height = small * impedance(tube);
  const auto reflected = [&](const TerminalLaw &end)
  {
    Network network = network_of({tube}, {pulse(small, 0.08), end});
    return extreme_after(network, 0, 0.21, 0.39) / height;
  };
  check::absolute("absorbing end", reflected(end_of(TerminalLaw::Type::absorbing)), 0., 5e-4);
  check::absolute("closed end", reflected(end_of(TerminalLaw::Type::closed)), 1., 0.015);
  TerminalLaw resistance = end_of(TerminalLaw::Type::resistance);
  resistance.resistance = 3. * impedance(tube);
  check::absolute("resistance", reflected(resistance), 0.5, 0.0075);
  TerminalLaw open = end_of(TerminalLaw::Type::pressure);
  open.value = [](double) { return 0.; };
  check::absolute("open end", reflected(open), -1., 0.015);

  // A pulse that widens the tube leaves, too: nearly where it has become a shock, and else up to
  // the error of the cells.
  const auto of_high_pulse = [&](const double flow, const double alpha, const double band)
  {
    const std::string name =
        "pulse of " + std::to_string(flow * 1e6) + " ml/s, alpha " + std::to_string(alpha) + ": ";
    Network network =
        network_of({tube}, {pulse(flow, 0.08), end_of(TerminalLaw::Type::absorbing)}, alpha);
    const double high = extreme_after(network, 0, 0., 0.2),
                 left = extreme_after(network, 0, 0.21, 0.39);
    check::is_true(name + "the tube widens", high > 1500. * flow / 1e-4 * 0.85);
    check::absolute(name + "what returns from an absorbing end", left / high, 0., band);
  };
  of_high_pulse(3e-4, 1., 2e-3);
  of_high_pulse(1e-4, 1., 2e-4);
  of_high_pulse(1e-4, 4. / 3., 2e-4);
}

void check_junction()
{
  const Tube parent = {0, 1, 1., 3e-4, 5., 100}, first = {1, 2, 1., 1e-4, 6., 100},
             second = {3, 1, 1., 1.5e-4, 8., 100}; // starts at its loose end
  const double small = 1e-9, height = small * impedance(parent);
  const TerminalLaw absorbing = end_of(TerminalLaw::Type::absorbing);
  const double inflow = 1. / impedance(parent),
               outflow = 1. / impedance(first) + 1. / impedance(second);
  const std::vector<TerminalLaw> laws = {pulse(small, 0.08), absorbing, absorbing, absorbing};
  Network network = network_of({parent, first, second}, laws);
  check::absolute("junction: reflected", extreme_after(network, 0, 0.21, 0.39) / height,
                  (inflow - outflow) / (inflow + outflow), 0.003);
  network = network_of({parent, first, second}, laws);
  check::absolute("junction: passes", extreme_after(network, 2, 0.2, 0.39) / height,
                  2. * inflow / (inflow + outflow), 0.01);
}

/// High waves: no liquid is lost, and p + rho alpha U^2/2 is the same on all sides.
void check_high_wave_at_junction(const double alpha)
{
  const std::string name = "junction, alpha " + std::to_string(alpha) + ": ";
  const Tube parent = {0, 1, 1., 3e-4, 5., 100}, first = {1, 2, 1., 1e-4, 6., 100},
             second = {3, 1, 1., 1.5e-4, 8., 100};
  const TerminalLaw absorbing = end_of(TerminalLaw::Type::absorbing);
  Network network = network_of({parent, first, second},
                               {pulse(2e-4, 0.3), absorbing, absorbing, absorbing}, alpha);
  const double volume = network.volume();
  network.advance(0.35, 0.9);
  check::absolute(name + "volume", network.volume() - volume - network.inflow(), 0.,
                  1e-13 * volume);
  const auto head = [&](const unsigned int vessel, const Vessel::End end)
  {
    const Vessel::State &state = network.vessel(vessel).end_state(end);
    const double velocity = state.flow / state.area;
    return network.vessel(vessel).pressure(end, state.area) +
           0.5 * alpha * density * velocity * velocity;
  };
  const double of_parent = head(0, Vessel::End::end);
  check::is_true(name + "there is a flow",
                 network.vessel(0).end_state(Vessel::End::end).flow > 1e-5);
  check::relative(name + "head of the first", head(1, Vessel::End::start), of_parent, 1e-10);
  check::relative(name + "head of the second", head(2, Vessel::End::end), of_parent, 1e-10);
}

/// A tube that is cut, once with its second part reversed, does as the whole one.
void check_cut_tube()
{
  const TerminalLaw absorbing = end_of(TerminalLaw::Type::absorbing), in = pulse(1e-4, 0.1);
  Network whole = network_of({{0, 1, 1., 3e-4, 5., 200}}, {in, absorbing}),
          cut = network_of({{0, 1, 0.5, 3e-4, 5., 100}, {2, 1, 0.5, 3e-4, 5., 100}},
                           {in, absorbing, absorbing});
  double largest = 0., difference = 0.;
  for (unsigned int i = 1; i <= 60; ++i)
  {
    whole.advance(0.005 * i, 0.8);
    cut.advance(0.005 * i, 0.8);
    const double pressure = whole.vessel(0).values(0.75).pressure;
    largest = std::fmax(largest, std::abs(pressure));
    difference = std::fmax(difference, std::abs(pressure - cut.vessel(1).values(0.25).pressure));
  }
  check::absolute("cut tube", difference / largest, 0., 1e-3);
}

/// Between a flow rate and a windkessel.
constexpr Tube stiff_tube = {0, 1, 0.01, 1e-5, 200., 5};

/// A constant flow rate into a windkessel through a tube whose impedance is that of the proximal
/// resistance, which the wave passes within `delay` [s]: the error of the pressure at the end [1].
/// Behind the first wave none returns, since the flow rate is given.
double error_of_windkessel(const double compliance)
{
  TerminalLaw in = end_of(TerminalLaw::Type::flow_rate),
              windkessel = end_of(TerminalLaw::Type::windkessel);
  in.value = [](double) { return 1e-6; };
  // Stiff: the tube stores a thousandth of what the compliance does.
  const Tube tube = stiff_tube;
  windkessel.resistance = impedance(tube);
  windkessel.distal_resistance = 1e9;
  windkessel.compliance = compliance;
  windkessel.pressure_behind = 100.;
  windkessel.initial_pressure = 100.;
  Network network = network_of({tube}, {in, windkessel});
  network.start_at_rest(100.);
  const double delay = 0.01 / 200.;
  network.advance(0.1, 0.9);
  const double exact = 100. + 1e-6 * (windkessel.resistance +
                                      1e9 * (1. - std::exp(-(0.1 - delay) / (1e9 * compliance))));
  return network.vessel(0).values(0.01).pressure / exact - 1.;
}

/// A flow rate that grows evenly: the liquid in the compliance then stands behind it by just the
/// time constant tau = distal resistance times compliance, p - pb = (Rp + Rd) Q - Rd tau dQ/dt,
/// however long the steps are. Returns this time over tau for steps of `x` tau.
double lag_of_windkessel(const double x)
{
  constexpr double step = 5e-6, growth = 1e-4; // s, m^3/s^2
  TerminalLaw in = end_of(TerminalLaw::Type::flow_rate),
              windkessel = end_of(TerminalLaw::Type::windkessel);
  in.value = [](const double time) { return growth * time; };
  windkessel.resistance = impedance(stiff_tube);
  windkessel.distal_resistance = 1e9;
  windkessel.compliance = step / (x * windkessel.distal_resistance);
  windkessel.pressure_behind = windkessel.initial_pressure = 100.;
  Network network = network_of({stiff_tube}, {in, windkessel});
  network.start_at_rest(100.);
  const auto outflow = [&]() { return network.vessel(0).end_state(Vessel::End::end).flow; };
  constexpr unsigned int n_steps = 2000;
  double before = 0.;
  for (unsigned int i = 1; i <= n_steps; ++i)
  {
    before = outflow();
    network.advance(step * i, 0.9);
  }
  check::is_true("windkessel: one step in each interval", network.n_steps() == n_steps);
  const Vessel::State state = network.vessel(0).end_state(Vessel::End::end);
  const double pressure = network.vessel(0).pressure(Vessel::End::end, state.area) - 100.,
               of_compliance = pressure - windkessel.resistance * state.flow;
  return (state.flow - of_compliance / windkessel.distal_resistance) /
         ((state.flow - before) / step) / (windkessel.distal_resistance * windkessel.compliance);
}

/// A distal resistance of any size leaves a compliance alone: what it stores over what has flowed
/// into it.
double stored_over_flow()
{
  constexpr double step = 5e-6, growth = 1e-4; // s, m^3/s^2
  TerminalLaw in = end_of(TerminalLaw::Type::flow_rate),
              windkessel = end_of(TerminalLaw::Type::windkessel);
  in.value = [](const double time) { return growth * time; };
  windkessel.resistance = impedance(stiff_tube);
  windkessel.distal_resistance = 1e20;
  windkessel.compliance = 1e-11;
  Network network = network_of({stiff_tube}, {in, windkessel});
  double volume = 0., before = 0.;
  Vessel::State state;
  for (unsigned int i = 1; i <= 2000; ++i)
  {
    network.advance(step * i, 0.9);
    state = network.vessel(0).end_state(Vessel::End::end);
    volume += 0.5 * step * (before + state.flow);
    before = state.flow;
  }
  const double pressure =
      network.vessel(0).pressure(Vessel::End::end, state.area) - windkessel.resistance * state.flow;
  return pressure * windkessel.compliance / volume;
}

/// A flow that the vessels cannot carry, and a step that is too small, end a run with a reason.
void check_failures()
{
  TerminalLaw in = end_of(TerminalLaw::Type::flow_rate);
  in.value = [](const double time) { return 0.1 * time; };
  Network network =
      network_of({{0, 1, 1., 3e-4, 5., 20}}, {in, end_of(TerminalLaw::Type::absorbing)});
  check::throws<StepFailure>(
      "a flow as fast as the wave", [&]() { network.advance(1., 0.8); },
      "vessel 'tube'.*Lower the flow rates");
  network = network_of({stiff_tube}, {end_of(TerminalLaw::Type::closed), in});
  check::throws<StepFailure>(
      "a step that is too small", [&]() { network.advance(1e6, 0.8); },
      "at 0 s: the step has come down to 8e-06 s in the vessel 'tube'");
}
} // namespace

UNIT_TEST(network)
{
  check_end_waves();
  check_reflections();
  check_junction();
  check_high_wave_at_junction(1.);
  check_high_wave_at_junction(4. / 3.);
  check_cut_tube();
  check::absolute("windkessel", error_of_windkessel(2e-10), 0., 1e-3);
  check::absolute("windkessel that fills within a step", error_of_windkessel(1e-16), 0., 1e-6);
  for (const double x : {0.1, 0.5, 2.})
    check::relative("windkessel: lag with a step of " + std::to_string(x) + " time constants",
                    lag_of_windkessel(x), 1., 1e-4);
  check::relative("windkessel that only stores", stored_over_flow(), 1., 1e-6);
  check_failures();
}
} // namespace test_of_network
