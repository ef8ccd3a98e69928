#include <continua/network/network_parameters.h>

#include <continua/base/joined.h>
#include <continua/base/units.h>
#include <continua/base/words.h>
#include <continua/network/neo_hookean_wall.h>
#include <continua/network/square_root_wall.h>
#include <continua/network/steady_network.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Continua
{
namespace
{
constexpr double pi = FlowLaw::pi;
} // namespace

void NetworkParameters::read_liquid(ParameterSection &section)
{
  section.add("Density", liquid.density, Dimensions::density,
              "Of the liquid; at an end of a body by itself, and only, that of the body.",
              Range::positive());
  section.add("Viscosity", liquid.viscosity, Dimensions::viscosity,
              "Of the liquid; at an end of a body by itself that of the body.",
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
  add_choice(section, "Friction", liquid.remembers, {{"steady", false}, {"womersley", true}},
             "steady - that of the profile, whatever was before; womersley - that of Poiseuille's "
             "profile, and the memory of the changes of the flow rate in a round tube, by "
             "exponentials: for small waves that of Womersley.");
  if (liquid.remembers && section.given("Profile exponent") && liquid.profile_exponent != 2.)
    section.refuse("Profile exponent", "the friction of Womersley has the profile of Poiseuille",
                   "Remove the entry, or set Friction = steady");
}

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
  section.add("Damping time", relaxation.damping_time, Dimensions::time,
              "Viscosity of the wall over its Young's modulus (Kelvin and Voigt), of vessels "
              "without a Material.",
              Range::not_negative());
  std::vector<double> shares, times;
  section.add("Relative moduli", shares, Dimensions::none,
              "Of branches that relax, over Young's modulus, of vessels without a Material [1].",
              Range::positive());
  section.add("Relaxation times", times, Dimensions::time, "Of these branches.", Range::positive());
  if (shares.size() != times.size())
    section.refuse("Relaxation times",
                   std::to_string(shares.size()) + " relative moduli stand beside " +
                       std::to_string(times.size()) + " relaxation times",
                   "Give as many of the one as of the other");
  for (std::size_t k = 0; k < shares.size(); ++k)
    relaxation.branches.push_back({shares[k], times[k]});
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
  section.add("Time step", time_step, Dimensions::time,
              "Of the steps, at most; 0: that of the waves, and in a network without vessels a "
              "thousandth of the period or the end time.",
              Range::not_negative());
  section.add("Period", period, Dimensions::time,
              "Of the beats. The run goes on until a beat is like the one before. 0: there are no "
              "beats, the run ends at the end time.",
              Range::not_negative());
  section.add("Most beats", most_beats, "After which the run ends in any case [1].", 2);
  add_choice(section, "Periodic state", by_newton, {{"beats", false}, {"newton", true}},
             "How it is found: beats - beat after beat, which takes long where a windkessel has a "
             "time of many beats; newton - by Newton's method for the state that a beat leaves as "
             "it is, with beats of its own between those of probes.csv.");
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
  read_liquid(section);
  read_wall(section);
  section.add("Initial pressure", initial_pressure, Dimensions::pressure,
              "Of the state at rest with which the run starts; with gravity at the first node that "
              "the vessels name, at ends of a body at the first boundary that stands at a node.");
  has_initial_pressure = section.given("Initial pressure");
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

  ParameterSection of_elements = section.subsection("Elements");
  for (const std::string &name : of_elements.subsections())
    elements.push_back(ElementEntries::read(of_elements.subsection(name)));

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
    of_station.add("Vessel", station.vessel, "Where the station is. Required without an Element.");
    of_station.add(
        "Element", station.element,
        "Of the section Elements, whose pressure and flow rate, or volume, are recorded. "
        "Chambers are recorded by themselves.");
    if (station.element.empty())
      of_station.require("Vessel");
    else if (!station.vessel.empty())
      of_station.refuse("Vessel", "the station is at the element '" + station.element + "'",
                        "Remove this or the Element");
    of_station.add("Position", station.position, Dimensions::length,
                   "Distance from the start of the vessel.", Range::not_negative());
    if (!station.element.empty() && station.position > 0.)
      of_station.refuse("Position", "the element '" + station.element + "' has no length",
                        "Remove this or the Element");
    stations.push_back(station);
  }
}

void NetworkParameters::read_materials(const ParameterSection &section,
                                       ParameterSection materials,
                                       const std::vector<std::string> &of_body)
{
  const std::vector<std::string> names = materials.subsections();
  for (VesselEntries &vessel : vessels)
  {
    if (vessel.material.empty())
    {
      vessel.wall = {vessel.youngs_modulus, poissons_ratio, relaxation};
      continue;
    }
    if (std::find(names.begin(), names.end(), vessel.material) == names.end())
      vessel.refuse("Material", "there is no material '" + vessel.material + "'",
                    names.empty() ? "Describe it in the section Materials"
                                  : "The materials are " + joined(names));
    try
    {
      vessel.wall = WallMaterial::of(
          read_material(materials.subsection(vessel.material), Model::three_dimensional));
      if (wall == Wall::neo_hookean && std::abs(vessel.wall.poissons_ratio - 0.5) > 1e-9)
        throw std::domain_error("is compressible, and a neo hookean wall is not");
    }
    catch (const std::domain_error &error)
    {
      vessel.refuse(
          "Material", "the material '" + vessel.material + "' " + error.what(),
          "Name a solid of type hookean, kelvin-voigt or prony with a Young's modulus and "
          "a Poisson's ratio that is constant (0.5, or Volumetric relaxation = as the "
          "shear)");
    }
  }
  check_materials(section, materials, of_body);
}

unsigned int NetworkParameters::n_cells(const VesselEntries &vessel) const
{
  return std::max(fewest_cells,
                  static_cast<unsigned int>(std::ceil(vessel.length / cell_length * (1. - 1e-9))));
}

double NetworkParameters::largest_step() const
{
  constexpr double in_a_beat = 1000.;
  if (time_step > 0.)
    return time_step;
  return vessels.empty() ? (period > 0. ? period : end_time) / in_a_beat
                         : std::numeric_limits<double>::infinity();
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
                                entries.wall.youngs_modulus / 3.);
        });
  return make_vessel<SquareRootWall>(
      description, liquid,
      [&](const double z)
      {
        const LongWaveTube tube{entries.radius(z), entries.thickness(z),
                                entries.wall.poissons_ratio, liquid.density, 0.};
        const double speed =
            korteweg_speed(tube, entries.wall.youngs_modulus, Anchoring::throughout, wall_theory)
                .real();
        return SquareRootWall(area(z), reference_pressure, liquid.density * speed * speed);
      });
}

bool NetworkParameters::gives_state_at_rest() const
{
  const auto gives = [](const auto &entries) { return entries.has_initial_pressure; };
  return has_initial_pressure || std::any_of(terminals.begin(), terminals.end(), gives) ||
         std::any_of(elements.begin(), elements.end(), gives);
}

std::vector<unsigned int> NetworkParameters::numbers_at_body() const
{
  std::vector<unsigned int> numbers;
  for (const std::string &name : nodes_at_body)
    numbers.push_back(node(name));
  return numbers;
}

bool NetworkParameters::has_steady_flow() const
{
  const std::function<double(double)> none = [](const double /*time*/) { return 0.; };
  Network network = make(std::vector<std::function<double(double)>>(nodes_at_body.size(), none));
  return SteadyNetwork(network, numbers_at_body()).exists();
}

Network
NetworkParameters::make(const std::vector<std::function<double(double)>> &inflows_of_body) const
{
  std::vector<Network::Edge> edges;
  for (const VesselEntries &vessel : vessels)
  {
    edges.push_back({make_vessel_of(vessel), node(vessel.from), node(vessel.to)});
    if (!vessel.wall.relaxation.is_elastic())
      edges.back().vessel->set_relaxation(vessel.wall.relaxation);
  }
  std::vector<TerminalLaw> laws(nodes.size());
  for (const TerminalEntries &terminal : terminals)
  {
    const unsigned int number = node(terminal.node);
    laws[number] = terminal.law;
    if (!terminal.has_initial_pressure)
      laws[number].initial_pressure =
          initial_pressure - liquid.density * liquid.gravity * heights[number];
  }
  Circuit::Description of_elements = circuit();
  for (std::size_t i = 0; i < inflows_of_body.size(); ++i)
  {
    if (has_element(nodes_at_body[i]))
    {
      of_elements.inflows.emplace_back(node(nodes_at_body[i]), inflows_of_body[i]);
      continue;
    }
    TerminalLaw &law = laws[node(nodes_at_body[i])];
    law.type = TerminalLaw::Type::flow_rate;
    law.value = inflows_of_body[i];
    law.initial_pressure =
        initial_pressure - liquid.density * liquid.gravity * heights[node(nodes_at_body[i])];
  }
  Network network(std::move(edges), laws, of_elements);
  network.start_at_rest(initial_pressure);
  return network;
}
} // namespace Continua
