#include <continua/network/network_parameters.h>

#include <continua/base/joined.h>
#include <continua/base/nearest_name.h>
#include <continua/base/units.h>
#include <continua/base/words.h>
#include <continua/network/neo_hookean_wall.h>
#include <continua/network/square_root_wall.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Continua
{
namespace
{
constexpr double pi = FlowLaw::pi;
/// Of heights that close a loop, relative to the sum of the rises.
constexpr double tolerance_of_heights = 1e-9;
constexpr double most_cells = 1e6;     ///< of a vessel
constexpr double most_intervals = 1e7; ///< of a beat, or of the run

/// A remedy for a name that nothing has.
std::string
known_names(const std::string &name, const std::vector<std::string> &names, const std::string &kind)
{
  const std::string nearest = nearest_name(name, names);
  return nearest.empty() ? "The " + kind + " are " + joined(names)
                         : "Did you mean '" + nearest + "'?";
}
} // namespace

void NetworkParameters::read_wall(ParameterSection &section)
{
  add_choice(section, "Wall", wall,
             {{"square root", Wall::square_root}, {"neo hookean", Wall::neo_hookean}},
             "Pressure over the area of a section: square root - p0 + beta (sqrt(A) - sqrt(A0)), "
             "the tube law of the field, for walls of small strain; neo hookean - the exact law of "
             "a thick incompressible wall that is held along its axis, for any strain.");
  add_choice(section, "Wall theory", wall_theory,
             {{"thin", WallTheory::thin}, {"thick", WallTheory::thick}},
             "With the square root, how beta follows from modulus and thickness: thin - the stress "
             "is the same over the thickness, beta = sqrt(pi) Y h/((1 - nu^2) A0); thick - as "
             "Lame's, with the pressure on the inner radius.");
  section.add("Poisson's ratio", poissons_ratio, Dimensions::none,
              "nu of the wall, which is held along its axis.", {0., 0.5, false, false});
  section.add("Reference pressure", reference_pressure, Dimensions::pressure,
              "Under which the vessels have their radii. The wall of a neo hookean vessel has no "
              "stress then, beside this pressure inside and outside.");
  if (wall == Wall::neo_hookean)
    for (const std::string key : {"Wall theory", "Poisson's ratio"})
      if (section.given(key))
        section.refuse(key, "a neo hookean wall is thick and incompressible", "Remove the entry");
}

void NetworkParameters::read_times(ParameterSection &section)
{
  section.add("Cell length", cell_length, Dimensions::length, "Of the cells, at most.",
              Range::positive());
  section.add("Fewest cells", fewest_cells, "In each vessel [1].", 2);
  section.add("Courant number", courant_number, Dimensions::none,
              "Largest way of a wave in a step over the length of the cell [1]. The steps follow "
              "from it. The friction limits them, too: by the same number times area/(2 pi (zeta + "
              "2) mu/rho), which is the shorter one in vessels that are very thin.",
              {0., 1., true, false});
  section.add("Period", period, Dimensions::time,
              "Of the beats. The run goes on until a beat is like the one before. 0: there are no "
              "beats, the run ends at the end time.",
              Range::not_negative());
  section.add("Most beats", most_beats, "After which the run ends in any case [1].", 2);
  section.add(
      "Tolerance", tolerance, Dimensions::none,
      "Of the periodic state: the largest difference of the pressure at a station from that "
      "a beat before, over its range in the beat [1]. A range below 1e-8 of the pressure counts as "
      "that.",
      Range::positive());
  section.add("End time", end_time, Dimensions::time, "Of a run without beats.",
              Range::not_negative());
  section.add("Output interval", output_interval, Dimensions::time,
              "Between two rows of probes.csv; 0: a two-hundredth of the period, or a thousandth "
              "of the end time. It is shortened so that the period, or the end time, has a whole "
              "number of it.",
              Range::not_negative());
}

void NetworkParameters::read(ParameterSection section)
{
  section.add("Density", liquid.density, Dimensions::density, "Of the liquid.", Range::positive());
  section.add("Viscosity", liquid.viscosity, Dimensions::viscosity, "Of the liquid.",
              Range::not_negative());
  section.add("Profile exponent", liquid.profile_exponent, Dimensions::none,
              "zeta of the velocity over the section, 1 - (r/R)^zeta, for the friction: 2 is the "
              "parabola of Poiseuille, 9 is nearly flat [1].",
              Range::positive());
  section.add("Momentum correction", liquid.momentum_correction, Dimensions::none,
              "alpha, mean square of the velocity over the square of its mean [1]. Most programs "
              "take 1 beside any friction; the profile has (zeta + 2)/(zeta + 1).",
              {1., std::numeric_limits<double>::infinity(), false, false});
  section.add("Gravity", liquid.gravity, Dimensions::acceleration,
              "Downwards. It acts where vessels have a Rise.", Range::not_negative());
  read_wall(section);
  section.add("Initial pressure", initial_pressure, Dimensions::pressure,
              "Of the state at rest with which the run starts; with gravity at the first node that "
              "the vessels name.");
  read_times(section);

  std::string file;
  section.add_input_file(
      "Vessel table", file,
      "A csv file of vessels, a row each, with the columns name, from, to, length, "
      "radius at start, radius at end, wall thickness at start, wall thickness at "
      "end, Young's modulus and, if you like, rise, with units in the header. It "
      "may stand beside the section Vessels.");
  if (!file.empty())
    vessels = VesselEntries::read_table(file);
  ParameterSection of_vessels = section.subsection("Vessels");
  for (const std::string &name : of_vessels.subsections())
    vessels.push_back(VesselEntries::read(of_vessels.subsection(name)));

  double pressure_behind = 0.;
  file.clear();
  section.add_input_file(
      "Terminal table", file,
      "A csv file of windkessels, a row each, with the columns node, proximal "
      "resistance, distal resistance and compliance. With a compliance of 0 it is "
      "a resistance, the sum of the two.");
  section.add("Pressure behind", pressure_behind, Dimensions::pressure,
              "Into which the liquid flows at the ends of the terminal table.");
  if (!file.empty())
    terminals = TerminalEntries::read_table(file, pressure_behind);
  else if (section.given("Pressure behind"))
    section.refuse("Pressure behind", "there is no terminal table",
                   "Write it into the sections of Terminals");
  ParameterSection of_terminals = section.subsection("Terminals");
  for (const std::string &node : of_terminals.subsections())
    terminals.push_back(TerminalEntries::read(of_terminals.subsection(node)));

  ParameterSection of_stations = section.subsection("Stations");
  for (const std::string &name : of_stations.subsections())
  {
    ParameterSection of_station = of_stations.subsection(name);
    Station station;
    station.name = name;
    of_station.add("Vessel", station.vessel, "Where the station is. Required.");
    of_station.require("Vessel");
    of_station.add("Position", station.position, Dimensions::length,
                   "Distance from the start of the vessel.", Range::not_negative());
    stations.push_back(station);
  }
}

unsigned int NetworkParameters::node(const std::string &name) const
{
  return std::find(nodes.begin(), nodes.end(), name) - nodes.begin();
}

void NetworkParameters::check(ParameterSection section)
{
  if (vessels.empty())
    section.refuse_missing("the network has no vessel",
                           "Give a 'Vessel table', or a section 'Vessels' with a subsection for "
                           "each vessel");
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
  for (const VesselEntries &vessel : vessels)
    if (vessel.length / cell_length > most_cells)
      section.refuse("Cell length",
                     "the vessel '" + vessel.name + "' of " + shortest_number(vessel.length) +
                         " m would have more than a million cells",
                     "Give a longer one");
  check_ends();
  set_heights();
  check_stations(section);
  check_times(section);
}

void NetworkParameters::check_ends()
{
  std::vector<unsigned int> n_ends(nodes.size(), 0);
  for (const VesselEntries &vessel : vessels)
    for (const std::string &name : {vessel.from, vessel.to})
      ++n_ends[node(name)];
  std::vector<bool> has_terminal(nodes.size(), false);
  for (const TerminalEntries &terminal : terminals)
  {
    const unsigned int number = node(terminal.node);
    if (number == nodes.size())
      terminal.refuse("no vessel starts or ends at a node '" + terminal.node + "'",
                      known_names(terminal.node, nodes, "nodes"));
    if (n_ends[number] > 1)
      terminal.refuse("at the node '" + terminal.node + "' " + std::to_string(n_ends[number]) +
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
      if (n_ends[node(name)] == 1 && !has_terminal[node(name)])
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
  heights.front() = 0.;
  double sum = 0.;
  for (const VesselEntries &vessel : vessels)
    sum += std::abs(vessel.rise);
  bool changed = true;
  while (changed)
  {
    changed = false;
    for (const VesselEntries &vessel : vessels)
    {
      double &from = heights[node(vessel.from)], &to = heights[node(vessel.to)];
      if (std::isnan(from) == std::isnan(to))
        continue;
      changed = true;
      if (std::isnan(to))
        to = from + vessel.rise;
      else
        from = to - vessel.rise;
    }
  }
  for (const VesselEntries &vessel : vessels)
  {
    const double from = heights[node(vessel.from)], to = heights[node(vessel.to)];
    if (std::isnan(from))
      vessel.refuse("From",
                    "the vessel '" + vessel.name + "' is not connected with the vessel '" +
                        vessels.front().name + "'",
                    "Let them meet in a node, or make a file for each network");
    if (std::abs(from + vessel.rise - to) > tolerance_of_heights * sum)
      vessel.refuse("Rise",
                    "along a loop with the vessel '" + vessel.name +
                        "' the rises have a sum that is not zero",
                    "Correct the rise of a vessel of the loop");
  }
}

void NetworkParameters::check_stations(ParameterSection &section)
{
  std::vector<std::string> names;
  for (const VesselEntries &vessel : vessels)
    names.push_back(vessel.name);
  if (stations.empty())
    section.refuse_missing("the network has no station where values are recorded",
                           "Write a section 'Stations' with a subsection for each station");
  for (Station &station : stations)
  {
    const ParameterSection of_station = section.subsection("Stations").subsection(station.name);
    station.vessel_number = std::find(names.begin(), names.end(), station.vessel) - names.begin();
    if (station.vessel_number == names.size())
      of_station.refuse("Vessel", "there is no vessel '" + station.vessel + "'",
                        known_names(station.vessel, names, "vessels"));
    const double length = vessels[station.vessel_number].length;
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
    for (const std::string key : {"Most beats", "Tolerance"})
      if (section.given(key))
        section.refuse(key, "there are no beats", "Remove the entry, or give a Period");
  const double whole = period > 0. ? period : end_time;
  if (output_interval > 0.5 * whole)
    section.refuse("Output interval", "is more than half of " + shortest_number(whole) + " s",
                   "Give a shorter one");
  if (output_interval > 0. && whole / output_interval > most_intervals)
    section.refuse("Output interval",
                   "probes.csv would have more than ten million rows in " + shortest_number(whole) +
                       " s",
                   "Give a longer one");
  for (const TerminalEntries &terminal : terminals)
    if (terminal.period > 0. && period > 0. && std::abs(terminal.period - period) > 1e-6 * period)
      section.refuse("Period",
                     "is not the " + shortest_number(terminal.period) +
                         " s after which the table of the terminal '" + terminal.node +
                         "' repeats itself",
                     "Correct it, or the 'Table period' of the terminal");
}

unsigned int NetworkParameters::n_cells(const VesselEntries &vessel) const
{
  return std::max(fewest_cells,
                  static_cast<unsigned int>(std::ceil(vessel.length / cell_length * (1. - 1e-9))));
}

unsigned int NetworkParameters::n_intervals() const
{
  constexpr unsigned int in_a_beat = 200, in_a_run = 1000;
  if (output_interval == 0.)
    return period > 0. ? in_a_beat : in_a_run;
  return static_cast<unsigned int>(
      std::ceil((period > 0. ? period : end_time) / output_interval * (1. - 1e-9)));
}

std::unique_ptr<Vessel> NetworkParameters::make_vessel_of(const VesselEntries &entries) const
{
  VesselDescription description;
  description.name = entries.name;
  description.length = entries.length;
  description.n_cells = n_cells(entries);
  description.height_at_start = heights[node(entries.from)];
  description.height_at_end = heights[node(entries.to)];
  const auto area = [&entries](const double z)
  { return pi * entries.radius(z) * entries.radius(z); };
  if (wall == Wall::neo_hookean)
    return make_vessel<NeoHookeanWall>(
        description, liquid,
        [&](const double z)
        {
          const double thickness = entries.thickness(z),
                       wall_area = pi * thickness * (2. * entries.radius(z) + thickness);
          return NeoHookeanWall(area(z), wall_area, reference_pressure,
                                entries.youngs_modulus / 3.);
        });
  return make_vessel<SquareRootWall>(
      description, liquid,
      [&](const double z)
      {
        const LongWaveTube tube{entries.radius(z), entries.thickness(z), poissons_ratio,
                                liquid.density, 0.};
        const double speed =
            korteweg_speed(tube, entries.youngs_modulus, Anchoring::throughout, wall_theory).real();
        return SquareRootWall(area(z), reference_pressure, liquid.density * speed * speed);
      });
}

Network NetworkParameters::make() const
{
  std::vector<Network::Edge> edges;
  for (const VesselEntries &vessel : vessels)
    edges.push_back({make_vessel_of(vessel), node(vessel.from), node(vessel.to)});
  std::vector<TerminalLaw> laws(nodes.size());
  for (const TerminalEntries &terminal : terminals)
  {
    const unsigned int number = node(terminal.node);
    laws[number] = terminal.law;
    if (!terminal.has_initial_pressure)
      laws[number].initial_pressure =
          initial_pressure - liquid.density * liquid.gravity * heights[number];
  }
  Network network(std::move(edges), laws);
  network.rest(initial_pressure);
  return network;
}
} // namespace Continua
