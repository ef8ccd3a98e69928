#include <continua/base/joined.h>
#include <continua/base/nearest_name.h>
#include <continua/base/six_digits.h>
#include <continua/base/units.h>
#include <continua/network/network_parameters.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
namespace
{
/// Of heights that close a loop, relative to the sum of the rises.
constexpr double tolerance_of_heights = 1e-9;
constexpr double most_cells = 1e6;       ///< of a vessel
constexpr double most_intervals = 1e7;   ///< of a beat, or of the run
constexpr unsigned int n_samples = 1000; ///< of an elastance, in the same time, at least
constexpr unsigned int most_samples = 1000000;

/// A remedy for a name that nothing has.
std::string
known_names(const std::string &name, const std::vector<std::string> &names, const std::string &kind)
{
  if (names.empty())
    return "There are no " + kind;
  const std::string nearest = nearest_name(name, names);
  return nearest.empty() ? "The " + kind + " are " + joined(names)
                         : "Did you mean '" + nearest + "'?";
}
} // namespace

unsigned int NetworkParameters::node(const std::string &name) const
{
  return std::find(nodes.begin(), nodes.end(), name) - nodes.begin();
}

unsigned int NetworkParameters::n_ends(const unsigned int node) const
{
  unsigned int n = 0;
  for (const VesselEntries &vessel : vessels)
    for (const std::string &name : {vessel.from, vessel.to})
      n += name == nodes[node] ? 1 : 0;
  return n;
}

bool NetworkParameters::is_at_body(const std::string &name) const
{
  return std::find(nodes_at_body.begin(), nodes_at_body.end(), name) != nodes_at_body.end();
}

void NetworkParameters::refuse_times(const ParameterSection &section)
{
  for (const char *const key : {"Period", "Most beats", "Periodic state", "Tolerance", "End time",
                                "Output interval", "Time step"})
    if (section.given(key))
      section.refuse(key, "the network at the end of a body goes on with the steps of the body",
                     "Remove the entry; the sections Time, Periodic state and Output have the "
                     "times of the run");
}

void NetworkParameters::check(ParameterSection section)
{
  if (vessels.empty() && elements.empty())
    section.refuse_missing("the network has no vessel and no element",
                           "Give a 'Vessel table', or a section 'Vessels' or 'Elements' with a "
                           "subsection for each of them");
  for (auto vessel = vessels.begin(); vessel != vessels.end(); ++vessel)
  {
    if (std::any_of(vessels.begin(), vessel,
                    [&](const VesselEntries &other) { return other.name == vessel->name; }))
      vessel->refuse("", "two vessels are called '" + vessel->name + "'", "Rename one of them");
    if (vessel->from == vessel->to)
      vessel->refuse("To", "the vessel '" + vessel->name + "' ends at the node where it starts",
                     "Name another node, or make two vessels of it");
    if (std::abs(vessel->rise) > vessel->length)
      vessel->refuse("Rise",
                     "the vessel '" + vessel->name + "' is " + shortest_number(vessel->length) +
                         " m long and cannot rise by " + shortest_number(vessel->rise) + " m",
                     "Correct the rise, its unit, or the length");
    for (const std::string &name : {vessel->from, vessel->to})
      if (node(name) == nodes.size())
        nodes.push_back(name);
  }
  for (const ElementEntries &element : elements)
    for (const std::string &name : {element.from, element.to})
      if (!name.empty() && node(name) == nodes.size())
        nodes.push_back(name);
  for (const VesselEntries &vessel : vessels)
    if (vessel.length / cell_length > most_cells)
      section.refuse("Cell length",
                     "the vessel '" + vessel.name + "' of " + shortest_number(vessel.length) +
                         " m would have more than a million cells",
                     "Give a longer one");
  check_ends();
  check_elements();
  set_heights();
  check_pressures();
  check_stations(section);
  if (nodes_at_body.empty())
    check_times(section);
}

void NetworkParameters::check_materials(const ParameterSection &section,
                                        ParameterSection materials,
                                        const std::vector<std::string> &of_body) const
{
  for (const std::string &name : materials.subsections())
    if (std::find(of_body.begin(), of_body.end(), name) == of_body.end() &&
        std::none_of(vessels.begin(), vessels.end(),
                     [&](const VesselEntries &vessel) { return vessel.material == name; }))
      materials.subsection(name).refuse(
          "", "no vessel has this material",
          "Remove the subsection; the liquid has its entries in the section Network");
  if (vessels.empty() ||
      std::any_of(vessels.begin(), vessels.end(),
                  [](const VesselEntries &vessel) { return vessel.material.empty(); }))
    return;
  // By the values, since --print-parameters writes the defaults.
  const std::string problem = "has no effect: each vessel has a Material",
                    remedy = "Remove the entry, and describe it in the materials";
  if (relaxation.damping_time > 0.)
    section.refuse("Damping time", problem, remedy);
  if (!relaxation.branches.empty())
    section.refuse("Relative moduli", problem, remedy);
  if (poissons_ratio != NetworkParameters().poissons_ratio)
    section.refuse("Poisson's ratio", problem, remedy);
}

void NetworkParameters::check_ends()
{
  std::vector<bool> has_terminal(nodes.size(), false);
  for (const TerminalEntries &terminal : terminals)
  {
    const unsigned int number = node(terminal.node);
    if (number == nodes.size())
      terminal.refuse("no vessel starts or ends at a node '" + terminal.node + "'",
                      known_names(terminal.node, nodes, "nodes"));
    if (is_at_body(terminal.node))
      terminal.refuse("at the node '" + terminal.node + "' stands the body",
                      "Remove the terminal, or name another node at the boundary of the body");
    if (n_ends(number) > 1 && !has_element(terminal.node))
      terminal.refuse("at the node '" + terminal.node + "' " + std::to_string(n_ends(number)) +
                          " vessels meet",
                      "Remove the terminal, or put it to a loose end");
    if (has_terminal[number])
      terminal.refuse("the node '" + terminal.node + "' has two terminals", "Remove one of them");
    has_terminal[number] = true;
  }
  for (const VesselEntries &vessel : vessels)
    for (const std::string key : {"From", "To"})
    {
      const std::string &name = key == "From" ? vessel.from : vessel.to;
      if (n_ends(node(name)) == 1 && !has_terminal[node(name)] && !is_at_body(name) &&
          !has_element(name))
        vessel.refuse(key,
                      "the vessel '" + vessel.name + "' has a loose end at the node '" + name + "'",
                      "Say in 'Terminals/" + name +
                          "' what stands there (Type = closed, windkessel, ...), or name the node "
                          "of another vessel");
    }
}

void NetworkParameters::set_heights()
{
  heights.assign(nodes.size(), std::nan(""));
  heights[nodes_at_body.empty() ? 0 : node(nodes_at_body.front())] = 0.;
  double sum = 0.;
  for (const VesselEntries &vessel : vessels)
    sum += std::abs(vessel.rise);
  // Networks at several ends of a body may meet in the body alone: each has its own zero.
  std::vector<std::string> zeros = nodes_at_body;
  bool changed = true;
  const auto connect = [&](double &from, double &to, const double rise)
  {
    if (std::isnan(from) == std::isnan(to))
      return;
    changed = true;
    if (std::isnan(to))
      to = from + rise;
    else
      from = to - rise;
  };
  while (changed)
  {
    changed = false;
    for (const VesselEntries &vessel : vessels)
      connect(heights[node(vessel.from)], heights[node(vessel.to)], vessel.rise);
    for (const ElementEntries &element : elements)
      if (!element.law.stores())
        connect(heights[node(element.from)], heights[node(element.to)], 0.);
    for (; !changed && !zeros.empty(); zeros.pop_back())
      if (double &height = heights[node(zeros.back())]; std::isnan(height))
      {
        height = 0.;
        changed = true;
      }
  }
  for (const VesselEntries &vessel : vessels)
  {
    const double from = heights[node(vessel.from)], to = heights[node(vessel.to)];
    if (std::isnan(from))
      vessel.refuse("From",
                    "the vessel '" + vessel.name + "' is not connected with " +
                        (nodes_at_body.empty() ? "the vessel '" + vessels.front().name + "'"
                                               : "a boundary of the body"),
                    nodes_at_body.empty()
                        ? "Let them meet in a node, or make a file for each network"
                        : "Let it meet a vessel that is, or remove it");
    if (std::abs(from + vessel.rise - to) > tolerance_of_heights * sum)
      vessel.refuse("Rise",
                    "along a loop with the vessel '" + vessel.name +
                        "' the rises have a sum that is not zero",
                    "Correct the rise of a vessel of the loop");
  }
  for (const ElementEntries &element : elements)
  {
    const double from = heights[node(element.from)],
                 to = element.law.stores() ? from : heights[node(element.to)];
    if (std::isnan(from))
      element.refuse(element.key_of_node(),
                     "the element '" + element.law.name + "' is not connected with the node '" +
                         nodes.front() + "'",
                     "Let it meet what is, or make a file for each network");
    if (std::abs(from - to) > tolerance_of_heights * sum)
      element.refuse(element.key_of_node(),
                     "the element '" + element.law.name +
                         "' has no length, and its nodes are at different heights",
                     "Correct the rises of the vessels between its nodes");
  }
}

void NetworkParameters::check_stations(ParameterSection &section)
{
  std::vector<std::string> of_vessels, of_elements, chambers;
  for (const VesselEntries &vessel : vessels)
    of_vessels.push_back(vessel.name);
  for (const ElementEntries &element : elements)
  {
    of_elements.push_back(element.law.name);
    if (element.law.type == ElementLaw::Type::chamber)
      chambers.push_back(element.law.name);
  }
  for (const TerminalEntries &terminal : terminals)
    if (terminal.law.type == TerminalLaw::Type::heart)
    {
      if (std::find(chambers.begin(), chambers.end(), terminal.node) != chambers.end())
        terminal.refuse("a chamber among the elements has the name of this node, under which the "
                        "chamber of the heart is recorded",
                        "Rename the element");
      chambers.push_back(terminal.node);
    }
  if (stations.empty() && chambers.empty() && nodes_at_body.empty())
    section.refuse_missing("the network has no station where values are recorded",
                           "Write a section 'Stations' with a subsection for each station");
  for (Station &station : stations)
  {
    const ParameterSection of_station = section.subsection("Stations").subsection(station.name);
    if (std::find(chambers.begin(), chambers.end(), station.name) != chambers.end())
      of_station.refuse("", "the chamber '" + station.name + "' is recorded under this name",
                        "Rename the station");
    const bool is_at_element = !station.element.empty();
    const std::string &name = is_at_element ? station.element : station.vessel,
                      kind = is_at_element ? "element" : "vessel";
    const std::vector<std::string> &names = is_at_element ? of_elements : of_vessels;
    station.number = std::find(names.begin(), names.end(), name) - names.begin();
    if (station.number == names.size())
      of_station.refuse(is_at_element ? "Element" : "Vessel",
                        "there is no " + kind + " '" + name + "'",
                        known_names(name, names, kind + "s"));
    if (is_at_element)
      continue;
    const double length = vessels[station.number].length;
    if (station.position > length)
      of_station.refuse("Position",
                        "the vessel '" + station.vessel + "' is " + shortest_number(length) +
                            " m long",
                        "Give a distance from its start up to this length");
  }
}

void NetworkParameters::check_times(const ParameterSection &section)
{
  if (period > 0. && section.given("End time"))
    section.refuse("End time", "the run ends when a beat is like the one before",
                   "Remove the entry, or set Period = 0");
  if (period == 0. && !(end_time > 0.))
    section.refuse_missing("the run has no end",
                           "Give the 'Period' of its beats, or an 'End time'");
  if (period == 0.)
    for (const std::string key : {"Most beats", "Periodic state", "Tolerance"})
      if (section.given(key))
        section.refuse(key, "there are no beats", "Remove the entry, or give a Period");
  const double duration = period > 0. ? period : end_time;
  if (output_interval > 0.5 * duration)
    section.refuse("Output interval", "is more than half of " + shortest_number(duration) + " s",
                   "Give a shorter one");
  if (output_interval > 0. && duration / output_interval > most_intervals)
    section.refuse("Output interval",
                   "probes.csv would have more than ten million rows in " +
                       shortest_number(duration) + " s",
                   "Give a longer one");
  if (time_step > 0. && duration / time_step > most_intervals)
    section.refuse("Time step",
                   "there would be more than ten million steps in " + shortest_number(duration) +
                       " s",
                   "Give a longer one");
  for (const TerminalEntries &terminal : terminals)
    if (terminal.period > 0. && period > 0. && std::abs(terminal.period - period) > 1e-6 * period)
      section.refuse("Period",
                     "is not the " + shortest_number(terminal.period) +
                         " s after which the table of the terminal '" + terminal.node +
                         "' repeats itself",
                     "Correct it, or the 'Table period' of the terminal");
  for (const ElementEntries &element : elements)
    if (element.period > 0. && period > 0. && std::abs(element.period - period) > 1e-6 * period)
      section.refuse("Period",
                     "is not the " + shortest_number(element.period) +
                         " s after which the table of the element '" + element.law.name +
                         "' repeats itself",
                     "Correct it, or the 'Table period' of the element");
  check_elastances(duration);
}

void NetworkParameters::check_elastances(const double duration, const double step) const
{
  const auto n = static_cast<unsigned int>(
      step > 0. ? std::clamp(std::ceil(duration / step), 1. * n_samples, 1. * most_samples)
                : n_samples);
  const auto problem_of = [&](const std::function<double(double)> &elastance)
  {
    for (unsigned int i = 0; i <= n; ++i)
      if (const double time = i * duration / n, value = elastance(time); !(value > 0.))
        return "its Elastance is " + six_digits(value) + " Pa/m^3 at " + six_digits(time) + " s";
    return std::string();
  };
  const std::string remedy = "Write a function that is positive at all times";
  for (const TerminalEntries &terminal : terminals)
    if (terminal.law.type == TerminalLaw::Type::heart)
      if (const std::string problem = problem_of(terminal.law.value); !problem.empty())
        terminal.refuse(problem, remedy);
  for (const ElementEntries &element : elements)
    if (element.law.type == ElementLaw::Type::chamber)
      if (const std::string problem = problem_of(element.law.elastance); !problem.empty())
        element.refuse("Elastance", problem, remedy);
}
} // namespace Continua
