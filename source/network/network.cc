#include <continua/network/network.h>

#include <continua/base/input_error.h>
#include <continua/base/six_digits.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Continua
{
namespace
{
/// Of a step over the time of a call of advance(): with a shorter one it would not end.
constexpr double smallest_step = 1e-9;
} // namespace

Network::Network(std::vector<Edge> all_edges,
                 const std::vector<TerminalLaw> &terminals,
                 const Circuit::Description &of_circuit)
    : edges(std::move(all_edges)), n_nodes(terminals.size())
{
  const bool remembers =
      std::any_of(edges.begin(), edges.end(),
                  [](const Edge &edge)
                  { return edge.vessel->wall_relaxes() || edge.vessel->flow_law().remembers; });
  for (const Edge &edge : edges)
    if (remembers && edge.vessel->memory() == nullptr)
      edge.vessel->set_relaxation({});
  std::vector<std::vector<std::pair<Vessel *, Vessel::End>>> ends(terminals.size());
  for (const Edge &edge : edges)
  {
    ends.at(edge.from).emplace_back(edge.vessel.get(), Vessel::End::start);
    ends.at(edge.to).emplace_back(edge.vessel.get(), Vessel::End::end);
  }
  std::vector<char> is_of_circuit(terminals.size(), 0);
  for (const ElementLaw &law : of_circuit.elements)
    for (const unsigned int node : {law.from, law.stores() ? law.from : law.to})
      if (node < terminals.size())
        is_of_circuit[node] = 1;
  std::vector<std::pair<unsigned int, EndWave>> ends_at_elements;
  for (std::size_t node = 0; node < ends.size(); ++node)
    if (is_of_circuit[node] != 0)
      for (const auto &[vessel, end] : ends[node])
        ends_at_elements.emplace_back(node, EndWave(*vessel, end));
    else if (ends[node].size() > 1)
      junctions.emplace_back(ends[node]);
    else if (ends[node].size() == 1)
      loose_ends.push_back({Terminal(*ends[node][0].first, ends[node][0].second, terminals[node]),
                            0., static_cast<unsigned int>(node)});
  elements = Circuit(of_circuit, std::move(ends_at_elements));
}

double Network::volume() const
{
  double sum = elements.volume();
  for (const Edge &edge : edges)
    sum += edge.vessel->volume();
  return sum;
}

double Network::energy() const
{
  double sum = elements.energy();
  for (const Edge &edge : edges)
    sum += edge.vessel->energy();
  for (const Loose &loose : loose_ends)
    sum += loose.terminal.energy();
  return sum;
}

void Network::start_at_rest(const double pressure)
{
  for (const Edge &edge : edges)
    edge.vessel->start_at_rest(pressure);
  if (elements.is_empty())
    return;
  bool has_states = true;
  for (const Edge &edge : edges)
    has_states = edge.vessel->reconstruct() && has_states;
  if (!has_states)
    check_state();
  elements.start_at_rest(now);
}

void Network::solve_memory(const bool at_end_of_step, const double length)
{
  bool wall_relaxes = false;
  for (const Edge &edge : edges)
    wall_relaxes = wall_relaxes || edge.vessel->wall_relaxes();
  if (!wall_relaxes)
  {
    for (const Edge &edge : edges)
      if (edge.vessel->memory() != nullptr)
      {
        edge.vessel->begin_memory_stage(at_end_of_step, length);
        edge.vessel->end_memory_stage(0., 0.); // does not matter
      }
    return;
  }
  std::vector<MemoryNodes::Edge> of_memory;
  for (const Edge &edge : edges)
    of_memory.push_back({edge.vessel.get(), edge.from, edge.to});
  std::vector<const Terminal *> terminals(n_nodes, nullptr);
  for (const Loose &loose : loose_ends)
    terminals[loose.node] = &loose.terminal;
  try
  {
    MemoryNodes(of_memory, n_nodes).solve(terminals, at_end_of_step, now, length);
  }
  catch (const std::domain_error &error)
  {
    throw StepFailure("at " + six_digits(now) + " s: " + error.what());
  }
}

void Network::solve_nodes(const bool at_end_of_step, const double length)
{
  try
  {
    for (Loose &loose : loose_ends)
    {
      const double inflow = loose.terminal.solve(at_end_of_step, now, length);
      if (at_end_of_step)
      {
        entered += 0.5 * length * (loose.first_inflow + inflow);
        loose.terminal.end_step(now, length);
      }
      else
      {
        loose.first_inflow = inflow;
        loose.first_pressure = loose.terminal.pressure();
      }
    }
    for (Junction &junction : junctions)
      junction.solve();
    if (!elements.is_empty())
    {
      elements.solve_stage(at_end_of_step, now, length);
      if (at_end_of_step)
        entered += elements.inflow_of_step();
    }
  }
  catch (const std::domain_error &error)
  {
    throw StepFailure("at " + six_digits(now) + " s: " + error.what() +
                      ". Lower the flow rates or the pressures at the terminals, or give a stiffer "
                      "wall");
  }
}

void Network::check_state() const
{
  for (const Edge &edge : edges)
  {
    const VesselProblem problem = edge.vessel->problem();
    if (!problem.text.empty())
      throw StepFailure("at " + six_digits(now) + " s, " + six_digits(problem.position) +
                        " m from the start of the vessel '" + edge.vessel->name() +
                        "': " + problem.text + ". " + problem.remedy);
  }
}

void Network::step(const double length)
{
  if (edges.empty())
    try
    {
      elements.step_alone(now, length);
      entered += elements.inflow_of_step();
    }
    catch (const std::domain_error &error)
    {
      throw StepFailure("at " + six_digits(now) + " s: " + error.what());
    }
  else
    step_vessels(length);
  ++steps;
}

void Network::step_vessels(const double length)
{
  for (const Edge &edge : edges)
    edge.vessel->begin_step();
  for (const bool at_end_of_step : {false, true})
  {
    solve_memory(at_end_of_step, length);
    bool has_states = true;
    for (const Edge &edge : edges)
      has_states = edge.vessel->reconstruct() && has_states;
    if (!has_states)
      check_state();
    solve_nodes(at_end_of_step, length);
    for (const Edge &edge : edges)
    {
      edge.vessel->advance(length, at_end_of_step ? 0.5 : 0.);
      if (edge.vessel->memory() != nullptr)
        edge.vessel->add_memory(at_end_of_step, length);
    }
  }
}

const Network::Loose &Network::loose_end(const unsigned int node) const
{
  return *std::find_if(loose_ends.begin(), loose_ends.end(),
                       [node](const Loose &loose) { return loose.node == node; });
}

const EndWave *Network::vessel_at(const unsigned int node) const
{
  return elements.has_node(node) ? elements.vessel_at(node) : &loose_end(node).terminal.end();
}

double Network::end_pressure(const unsigned int node) const
{
  return elements.has_node(node) ? elements.pressure(node) : loose_end(node).terminal.pressure();
}

double Network::mean_pressure(const unsigned int node) const
{
  return elements.has_node(node) ? means_of_elements[node] : loose_end(node).mean_pressure;
}

double Network::largest_step() const
{
  double largest = std::numeric_limits<double>::infinity();
  for (const Edge &edge : edges)
    largest = std::min(largest, edge.vessel->largest_step());
  return largest;
}

bool Network::advance_in(const double end_time, const unsigned int n_steps)
{
  const double begin = now, length = (end_time - begin) / n_steps;
  for (Loose &loose : loose_ends)
    loose.mean_pressure = 0.;
  means_of_elements.assign(n_nodes, 0.);
  for (unsigned int i = 1; i <= n_steps; ++i)
  {
    if (length > largest_step())
      return false;
    step_vessels(length); // also without vessels: both stages have the mean that enters the body
    ++steps;
    now = i < n_steps ? begin + i * length : end_time;
    check_state();
    for (Loose &loose : loose_ends)
      loose.mean_pressure +=
          0.5 * (loose.first_pressure + loose.terminal.pressure() - 2. * loose.mean_pressure) / i;
    for (unsigned int node = 0; node < n_nodes; ++node)
      if (elements.has_node(node))
        means_of_elements[node] += (elements.mean_pressure(node) - means_of_elements[node]) / i;
  }
  return true;
}

void Network::visit_state(StateNumbers &numbers)
{
  for (const Edge &edge : edges)
    edge.vessel->visit(numbers);
  for (Loose &loose : loose_ends)
    loose.terminal.visit(numbers);
  elements.visit(numbers);
}

void Network::visit(StateNumbers &numbers)
{
  visit_state(numbers);
  for (Loose &loose : loose_ends)
    loose.terminal.visit_sums(numbers);
  elements.visit_sums(numbers);
  numbers.value(now);
  numbers.value(entered);
  numbers.value(steps);
}

void Network::advance(const double end_time, const double courant_number, const double most)
{
  const double begin = now;
  while (now < end_time)
  {
    double largest = std::min(end_time - now, most);
    for (const Edge &edge : edges)
    {
      largest = std::min(largest, courant_number * edge.vessel->largest_step());
      if (!(largest > smallest_step * (end_time - begin)))
        throw StepFailure("at " + six_digits(now) + " s: the step has come down to " +
                          six_digits(largest) + " s in the vessel '" + edge.vessel->name() +
                          "', whose waves are too fast for its cells or whose friction is too "
                          "large. Give longer cells, a softer wall or larger radii");
    }
    const double n_left = std::ceil((end_time - now) / largest * (1. - 1e-12)),
                 length = (end_time - now) / n_left;
    step(length);
    now = n_left > 1. ? now + length : end_time;
    check_state();
  }
}
} // namespace Continua
