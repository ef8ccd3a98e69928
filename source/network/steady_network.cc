#include <continua/network/steady_network.h>

#include <continua/base/input_error.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
namespace
{
constexpr unsigned int most_steady_iterations = 50, most_steady_halvings = 30;
/// Of the largest pressure and the largest flow rate; the error after the last correction is much
/// smaller.
constexpr double steady_tolerance = 1e-11;
/// Of A dp/dA of a vessel and of A c: for differences; and as which smaller values count.
constexpr double difference = 1e-6, least_value = 1e-3;
/// What a closed valve lets through, as in a Circuit.
constexpr double leak = 1e-9;
/// Of a closed valve that has none while it is open [Pa s/m^3]: that of a small artery.
constexpr double closed_resistance = 1e9;
/// Of a load over its period, of which the mean is taken.
constexpr unsigned int n_samples = 4096;

/// [m^3/s]: of a liquid as fast as the wave, at the start of a vessel.
double flow_scale(const Vessel &vessel)
{
  const double area = vessel.end_state(Vessel::End::start).area;
  return area *
         std::sqrt(area * vessel.stiffness(Vessel::End::start, area) / vessel.flow_law().density);
}

double pressure_scale(const Vessel &vessel)
{
  const double area = vessel.end_state(Vessel::End::start).area;
  return area * vessel.stiffness(Vessel::End::start, area);
}

double dynamic_pressure(const Vessel &vessel, const double area, const double flow)
{
  const FlowLaw &law = vessel.flow_law();
  return 0.5 * law.density * law.momentum_correction * flow * flow / (area * area);
}
} // namespace

SteadyNetwork::SteadyNetwork(Network &network, const std::vector<unsigned int> &nodes)
    : network(network), nodes(nodes)
{
  std::size_t n = network.n_nodes;
  const Circuit &circuit = network.elements;
  for (unsigned int k = 0; k < circuit.n_elements(); ++k)
  {
    const ElementLaw &law = circuit.law(k);
    n = std::max<std::size_t>(n, (law.stores() ? law.from : std::max(law.from, law.to)) + 1);
  }
  std::vector<unsigned int> n_ends(n, 0);
  for (const Network::Edge &edge : network.edges)
  {
    ++n_ends[edge.from];
    ++n_ends[edge.to];
  }
  is_junction.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i)
    is_junction[i] = n_ends[i] > 1 ? 1 : 0;
  for (unsigned int k = 0; k < circuit.n_elements(); ++k)
  {
    const ElementLaw &law = circuit.law(k);
    is_junction[law.from] = is_junction[law.stores() ? law.from : law.to] = 0;
  }
  unknowns.assign(n + network.edges.size() + circuit.n_elements(), 0.);
  for (const Network::Edge &edge : network.edges)
    for (const auto &[node, end] :
         {std::make_pair(edge.from, Vessel::End::start), std::make_pair(edge.to, Vessel::End::end)})
      unknowns[node] = edge.vessel->pressure(end, edge.vessel->end_state(end).area);
  slopes.assign(nodes.size(), std::vector<double>(unknowns.size(), 0.));
}

bool SteadyNetwork::exists() const
{
  using Type = TerminalLaw::Type;
  std::vector<char> holds(n_nodes(), 0); // a pressure, whatever flows
  for (const Network::Loose &loose : network.loose_ends)
  {
    const Type type = loose.terminal.end_law().type;
    if (type == Type::heart)
      return false;
    holds[loose.node] = type == Type::pressure || type == Type::resistance ||
                                type == Type::windkessel || type == Type::absorbing
                            ? 1
                            : 0;
  }
  const Circuit &circuit = network.elements;
  for (const auto &[node, load] : circuit.given_pressures())
    holds[node] = 1;
  for (unsigned int k = 0; k < circuit.n_elements(); ++k)
    if (circuit.law(k).type == ElementLaw::Type::chamber)
      return false;
  for (bool changed = true; changed;)
  {
    changed = false;
    const auto connect = [&](const unsigned int a, const unsigned int b)
    {
      if (holds[a] == holds[b])
        return;
      holds[a] = holds[b] = 1;
      changed = true;
    };
    for (const Network::Edge &edge : network.edges)
      connect(edge.from, edge.to);
    for (unsigned int k = 0; k < circuit.n_elements(); ++k)
      // What a valve lets through in one direction is no steady flow for any flow rate.
      if (circuit.law(k).type == ElementLaw::Type::resistance)
        connect(circuit.law(k).from, circuit.law(k).to);
  }
  return std::all_of(holds.begin(), holds.end(), [](const char has) { return has != 0; });
}

double SteadyNetwork::value(const std::function<double(double)> &load, const When &when)
{
  if (!(when.period > 0.))
    return load(when.time);
  double sum = 0.;
  for (unsigned int i = 0; i < n_samples; ++i)
    sum += load((i + 0.5) * when.period / n_samples);
  return sum / n_samples;
}

double SteadyNetwork::start_pressure(const unsigned int edge,
                                     const double at_node,
                                     const double flow) const
{
  const Vessel &vessel = *network.edges[edge].vessel;
  if (is_junction[network.edges[edge].from] == 0)
    return at_node;
  double area = vessel.end_state(Vessel::End::start).area, pressure = at_node;
  for (unsigned int i = 0; i < most_steady_iterations; ++i)
  {
    const double last = pressure;
    pressure = at_node - dynamic_pressure(vessel, area, flow);
    area = vessel.area_at(Vessel::End::start, pressure, area);
    if (!(area > 0.))
      break;
    if (std::abs(pressure - last) <= 1e-15 * pressure_scale(vessel))
      return pressure;
  }
  if (area > 0.)
    return pressure;
  throw std::domain_error("the wall of the vessel '" + vessel.name() +
                          "' has no state under the pressure at its start");
}

double
SteadyNetwork::at_end(const unsigned int edge, const double at_start, const double flow) const
{
  const Vessel &vessel = *network.edges[edge].vessel;
  const double pressure = vessel.steady_end_pressure(flow, start_pressure(edge, at_start, flow));
  if (is_junction[network.edges[edge].to] == 0)
    return pressure;
  const double area =
      vessel.area_at(Vessel::End::end, pressure, vessel.end_state(Vessel::End::end).area);
  return pressure + dynamic_pressure(vessel, area, flow);
}

void SteadyNetwork::set_vessel(const unsigned int edge)
{
  const Network::Edge &of = network.edges[edge];
  const std::size_t row = place_of_vessel(edge);
  const double at_start = unknowns[of.from], flow = unknowns[row],
               of_pressure = difference * pressure_scale(*of.vessel),
               of_flow = difference * flow_scale(*of.vessel), end = at_end(edge, at_start, flow);
  defects[row] = unknowns[of.to] - end;
  matrix[row][of.to] += 1.;
  matrix[row][of.from] -= (at_end(edge, at_start + of_pressure, flow) - end) / of_pressure;
  matrix[row][row] -= (at_end(edge, at_start, flow + of_flow) - end) / of_flow;
  defects[of.from] -= flow;
  defects[of.to] += flow;
  matrix[of.from][row] -= 1.;
  matrix[of.to][row] += 1.;
}

double SteadyNetwork::absorbing_defect(const Terminal &terminal,
                                       const double pressure,
                                       const double outflow) const
{
  const EndWave &wave = terminal.end();
  const Vessel &vessel = wave.of();
  const double near = vessel.end_state(wave.at()).area,
               area = vessel.area_at(wave.at(), pressure, near),
               at_rest = vessel.area_at(wave.at(), terminal.end_law().initial_pressure, near);
  if (!(area > 0.))
    throw std::domain_error("the wall of the vessel '" + vessel.name() +
                            "' has no state at its absorbing end");
  return outflow - wave.direction() * area * wave.leaving(at_rest, area).first;
}

void SteadyNetwork::set_terminal(const Network::Loose &loose, const When &when)
{
  using Type = TerminalLaw::Type;
  const unsigned int node = loose.node;
  if (std::find(nodes.begin(), nodes.end(), node) != nodes.end())
    return; // the flow rate into it is given
  const TerminalLaw &law = loose.terminal.end_law();
  // So far the row has what flows into the node: the flow rate into the terminal.
  const double outflow = defects[node], pressure = unknowns[node];
  std::vector<double> &row = matrix[node];
  const auto set_resistance = [&](const double resistance, const double behind)
  {
    for (double &entry : row)
      entry *= -resistance;
    row[node] += 1.;
    defects[node] = pressure - behind - resistance * outflow;
  };
  switch (law.type)
  {
  case Type::flow_rate:
    defects[node] += value(law.value, when);
    break;
  case Type::pressure:
    set_resistance(0., value(law.value, when));
    break;
  case Type::resistance:
    set_resistance(law.resistance, law.pressure_behind);
    break;
  case Type::windkessel:
    set_resistance(law.resistance + law.distal_resistance, law.pressure_behind);
    break;
  case Type::absorbing:
  {
    const double step = difference * pressure_scale(loose.terminal.end().of()),
                 defect = absorbing_defect(loose.terminal, pressure, outflow);
    row[node] += (absorbing_defect(loose.terminal, pressure + step, outflow) - defect) / step;
    defects[node] = defect;
    break;
  }
  case Type::closed:
  case Type::heart:
    break;
  }
}

void SteadyNetwork::set_elements(const When &when)
{
  const Circuit &circuit = network.elements;
  for (const auto &[node, load] : circuit.given_inflows())
    if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
      defects[node] += value(load, when);
  for (unsigned int k = 0; k < circuit.n_elements(); ++k)
  {
    const ElementLaw &law = circuit.law(k);
    const std::size_t row = place_of_element(k);
    if (law.stores())
    {
      defects[row] = unknowns[row];
      matrix[row][row] = 1.;
      continue;
    }
    const double flow = unknowns[row], pressure = unknowns[law.from] - unknowns[law.to];
    // An open valve without a resistance, which then has an inertance, has no difference of
    // pressures.
    const bool is_valve = law.type == ElementLaw::Type::valve, has_resistance = law.resistance > 0.,
               is_closed = is_valve && (pressure < 0. || (!has_resistance && flow < 0.));
    const double share = is_closed ? leak : 1.,
                 resistance = is_closed && !has_resistance ? closed_resistance : law.resistance;
    defects[row] = share * pressure - resistance * flow;
    matrix[row][law.from] += share;
    matrix[row][law.to] -= share;
    matrix[row][row] -= resistance;
    defects[law.from] -= flow;
    defects[law.to] += flow;
    matrix[law.from][row] -= 1.;
    matrix[law.to][row] += 1.;
  }
  for (const auto &[node, load] : circuit.given_pressures())
  {
    std::fill(matrix[node].begin(), matrix[node].end(), 0.);
    matrix[node][node] = 1.;
    defects[node] = unknowns[node] - value(load, when);
  }
}

void SteadyNetwork::set_equations(const std::vector<double> &flow_rates, const When &when)
{
  const std::size_t n = unknowns.size();
  matrix.assign(n, std::vector<double>(n, 0.));
  defects.assign(n, 0.);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    defects[nodes[i]] += flow_rates[i];
  for (unsigned int e = 0; e < network.edges.size(); ++e)
    set_vessel(e);
  for (const Network::Loose &loose : network.loose_ends)
    set_terminal(loose, when);
  set_elements(when);
}

bool SteadyNetwork::solve_for(const std::vector<double> &right)
{
  rows = matrix;
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i].push_back(-right[i]);
  return solve_rows(rows, change);
}

void SteadyNetwork::solve(const std::vector<double> &flow_rates, const When &when)
{
  double of_pressure = 0., of_flow = 0.; // scales
  for (const Network::Edge &edge : network.edges)
  {
    of_pressure = std::max(of_pressure, least_value * pressure_scale(*edge.vessel));
    of_flow = std::max(of_flow, least_value * flow_scale(*edge.vessel));
  }
  std::string problem = "Newton's method has not found it";
  try
  {
    set_equations(flow_rates, when);
    for (unsigned int i = 0; i < most_steady_iterations; ++i)
    {
      if (!solve_for(defects))
        break;
      old = unknowns;
      double share = 1.;
      for (unsigned int halvings = 0;; ++halvings, share *= 0.5)
        try
        {
          for (std::size_t k = 0; k < unknowns.size(); ++k)
            unknowns[k] = old[k] + share * change[k];
          set_equations(flow_rates, when);
          break;
        }
        catch (const std::domain_error &)
        {
          if (halvings == most_steady_halvings)
            throw;
        }
      double pressure_change = 0., flow_change = 0.;
      for (std::size_t k = 0; k < unknowns.size(); ++k)
      {
        double &scale = k < n_nodes() ? of_pressure : of_flow,
               &largest = k < n_nodes() ? pressure_change : flow_change;
        scale = std::max(scale, std::abs(unknowns[k]));
        largest = std::max(largest, std::abs(change[k]));
      }
      if (pressure_change > steady_tolerance * of_pressure ||
          flow_change > steady_tolerance * of_flow)
        continue;
      const std::vector<double> none(unknowns.size(), 0.);
      for (std::size_t j = 0; j < nodes.size(); ++j)
      {
        std::vector<double> right = none;
        right[nodes[j]] = 1.;
        if (!solve_for(right))
          throw std::domain_error(problem);
        slopes[j] = change;
      }
      return;
    }
  }
  catch (const std::domain_error &error)
  {
    problem = error.what();
  }
  throw StepFailure("the network has no steady flow: " + problem +
                    ". Give it an Initial pressure, with which a start of the type steady lets it "
                    "wait at rest, or set Initial state/Type = given");
}

void SteadyNetwork::start()
{
  for (unsigned int e = 0; e < network.edges.size(); ++e)
  {
    const Network::Edge &edge = network.edges[e];
    const double flow = unknowns[place_of_vessel(e)];
    edge.vessel->start_steady(flow, start_pressure(e, unknowns[edge.from], flow));
  }
  for (Network::Loose &loose : network.loose_ends)
  {
    const EndWave &wave = loose.terminal.end();
    const Vessel::State &state = wave.of().end_state(wave.at());
    loose.terminal.start_steady(unknowns[loose.node], wave.direction() * state.flow);
  }
  network.elements.start_steady(unknowns, unknowns.data() + place_of_element(0));
}
} // namespace Continua
