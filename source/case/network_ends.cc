#include <continua/case/network_ends.h>

#include <continua/base/joined.h>
#include <continua/base/nearest_name.h>
#include <continua/base/six_digits.h>
#include <continua/boundary/outlets.h>
#include <continua/mesh/coordinates.h>
#include <continua/mesh/round_section.h>
#include <continua/network/network_parameters.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Continua
{
using namespace dealii;

namespace
{
/// Of a section, over its extent: less is flat.
constexpr double flatness = 1e-6;
/// Of the areas of body and vessel at a joint: less needs no word.
constexpr double most_difference_of_areas = 0.1;
/// Of the pressure at the start, between both.
constexpr double least_jump = 1e-6;

bool is_alike(const double a, const double b)
{
  return std::abs(a - b) <= 1e-9 * std::abs(a);
}

std::vector<unsigned int> conditions_at_network(const Problem &problem)
{
  std::vector<unsigned int> numbers;
  for (unsigned int c = 0; c < problem.conditions.size(); ++c)
    if (problem.conditions[c].type == BoundaryType::network)
      numbers.push_back(c);
  return numbers;
}

/// Whether a boundary lies in a plane that liquid can pass as through the section of a tube; in
/// axisymmetry one across the axis.
template <int dim>
bool is_section(const Case<dim> &input, const BoundaryCondition &condition)
{
  std::vector<Point<dim>> points;
  for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
    if (condition.region_ids.count(cell->material_id()) > 0)
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == condition.boundary_id)
          for (unsigned int v = 0; v < cell->face(f)->n_vertices(); ++v)
            points.push_back(cell->face(f)->vertex(v));
  Tensor<1, dim> normal;
  double extent = 0.;
  for (const Point<dim> &point : points)
    extent = std::max(extent, points.front().distance(point));
  if (input.problem.model == Model::axisymmetric)
    normal[0] = 1.;
  else if constexpr (dim == 3)
  {
    // Of the largest triangle with the first edge that is long.
    double largest = 0.;
    for (const Point<dim> &second : points)
      for (unsigned int i = 0; i < std::min<std::size_t>(points.size(), 64); ++i)
      {
        const Tensor<1, dim> across =
            cross_product_3d(second - points.front(), points[i] - points.front());
        if (across.norm() > largest)
        {
          largest = across.norm();
          normal = across / across.norm();
        }
      }
  }
  else
    return true;
  return std::all_of(points.begin(), points.end(),
                     [&](const Point<dim> &point)
                     { return std::abs((point - points.front()) * normal) <= flatness * extent; });
}

/// What a boundary must be at which a network stands.
template <int dim>
void check_boundary(const Case<dim> &input,
                    const BoundaryCondition &condition,
                    const ParameterSection &section)
{
  for (const unsigned int region : condition.region_ids)
    if (input.problem.materials[region].is_solid())
      section.refuse("Type", "the boundary belongs to a solid, out of which nothing flows",
                     "Name the liquid's 'Region' and give the solid's part a condition of its own");
  if (!is_section(input, condition))
    section.refuse("Type",
                   input.problem.model == Model::axisymmetric
                       ? "the boundary is no section across the axis, which a vessel could go on "
                         "from"
                       : "the boundary is not plane, and no section which a vessel could go on "
                         "from",
                   "Give an inlet or an outlet of the body this Type");
}

/// Of the vessel that ends at a node, inside it [m]; 0 where elements alone stand there.
double radius_at(const NetworkParameters &network, const std::string &node)
{
  for (const VesselEntries &vessel : network.vessels)
    if (vessel.from == node || vessel.to == node)
      return vessel.from == node ? vessel.radius_at_start : vessel.radius_at_end;
  return 0.;
}

/// Of a body at a network: "" where its section is no disc, or has the area of the vessel.
template <int dim>
std::string warning_of_area(const Case<dim> &input, const BoundaryCondition &condition)
{
  const double radius_of_vessel = radius_at(*input.network, condition.node);
  if ((dim == 2 && input.problem.model != Model::axisymmetric) || radius_of_vessel == 0.)
    return "";
  double radius = 0.;
  try
  {
    radius = find_round_section(*input.triangulation, condition.boundary_id, condition.region_ids)
                 .radius;
  }
  catch (const std::invalid_argument &)
  {
    return "";
  }
  const double of_body = numbers::PI * radius * radius,
               of_vessel = numbers::PI * radius_of_vessel * radius_of_vessel;
  if (std::abs(of_vessel - of_body) <= most_difference_of_areas * of_body)
    return "";
  return "the section of the body at '" + condition.name + "' has " + six_digits(of_body) +
         " m^2, that of the vessel at the node '" + condition.node + "' " + six_digits(of_vessel) +
         " m^2: the joint reflects a part of each wave, and has the same pressure on both sides, "
         "not the same head";
}

/// What a node must be at which a body stands.
void check_node(const NetworkParameters &network,
                const BoundaryCondition &condition,
                const std::vector<std::string> &earlier,
                const ParameterSection &section)
{
  std::vector<std::string> names;
  for (const VesselEntries &vessel : network.vessels)
    for (const std::string &name : {vessel.from, vessel.to})
      if (std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  for (const ElementEntries &element : network.elements)
    for (const std::string &name : {element.from, element.to})
      if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  if (std::find(names.begin(), names.end(), condition.node) == names.end())
  {
    const std::string nearest = nearest_name(condition.node, names);
    section.refuse("Node", "no vessel and no element is at a node '" + condition.node + "'",
                   names.empty()     ? "Describe vessels or elements in the section Network"
                   : nearest.empty() ? "The nodes are " + joined(names)
                                     : "Did you mean '" + nearest + "'?");
  }
  unsigned int n_ends = 0;
  for (const VesselEntries &vessel : network.vessels)
    n_ends += (vessel.from == condition.node) + (vessel.to == condition.node);
  if (n_ends > 1 && !network.has_element(condition.node))
    section.refuse("Node",
                   "at the node '" + condition.node + "' " + std::to_string(n_ends) +
                       " vessels meet, and a body stands at the loose end of one",
                   "Put a short vessel between the body and this node");
  if (std::find(earlier.begin(), earlier.end(), condition.node) != earlier.end())
    section.refuse("Node", "another boundary stands at the node '" + condition.node + "'",
                   "Name another node");
}

/// The liquid of the network is that of the body.
template <int dim>
void check_liquid(const Case<dim> &input,
                  const NetworkParameters &network,
                  const ParameterSection &section)
{
  for (const unsigned int c : conditions_at_network(input.problem))
    for (const unsigned int region : input.problem.conditions[c].region_ids)
    {
      const Shear &shear = input.problem.materials[region].shear;
      if (!section.given("Viscosity") && shear.flow_curve)
        section.refuse_missing("the viscosity of the liquid '" + input.problem.regions[region] +
                                   "' depends on the rate of shear, and that of a network does not",
                               "Give the 'Viscosity' at the rates of shear in the vessels");
      if (!section.given("Viscosity") && !is_alike(shear.viscosity, network.liquid.viscosity))
        section.refuse_missing("the body has liquids of different viscosities at the network, " +
                                   six_digits(network.liquid.viscosity) + " Pa s and " +
                                   six_digits(shear.viscosity) + " Pa s",
                               "Give the 'Viscosity' of the network");
      const double density = input.problem.materials[region].density;
      if (!is_alike(density, network.liquid.density))
        section.refuse("Density",
                       six_digits(network.liquid.density) + " kg/m^3 are not the " +
                           six_digits(density) + " kg/m^3 of the liquid '" +
                           input.problem.regions[region] + "' of the body",
                       "Remove the entry, which by itself is that of the body");
    }
}
} // namespace

template <int dim>
void read_network_of_body(Case<dim> &input, ParameterSection root)
{
  const std::vector<unsigned int> at_network = conditions_at_network(input.problem);
  if (at_network.empty())
  {
    if (root.sets_in_subsection("Network"))
      root.subsection("Network").refuse(
          "", "no boundary of the body stands at a node of the network",
          "Give a boundary Type = network with its Node, remove the section, or set Analysis = "
          "nonlinear wave theory");
    return;
  }
  ParameterSection section = root.subsection("Network"), boundaries = root.subsection("Boundaries");
  const auto network = std::make_shared<NetworkParameters>();
  const BoundaryCondition &first = input.problem.conditions[at_network.front()];
  const Material &liquid = input.problem.materials[*first.region_ids.begin()];
  if (!liquid.is_solid())
  {
    network->liquid.density = liquid.density;
    network->liquid.viscosity = liquid.shear.viscosity;
  }
  network->read(section);
  NetworkParameters::refuse_times(section);
  network->read_materials(section, root.subsection("Materials"), input.problem.regions);
  for (const unsigned int c : at_network)
  {
    const BoundaryCondition &condition = input.problem.conditions[c];
    const ParameterSection of_boundary = boundaries.subsection(condition.name);
    check_boundary(input, condition, of_boundary);
    check_node(*network, condition, network->nodes_at_body, of_boundary);
    network->nodes_at_body.push_back(condition.node);
  }
  check_liquid(input, *network, section);
  network->check(section);
  network->check_elastances(input.time.end_time, input.time.time_step);
  try
  {
    network->make();
  }
  catch (const std::domain_error &error)
  {
    section.refuse("Initial pressure", error.what(),
                   "Give a pressure nearer to the Reference pressure, or a stiffer wall");
  }
  if (input.problem.interior.starts_under_mean_loads && !network->has_steady_flow())
    root.subsection("Initial state")
        .refuse(
            "Type",
            "the network has no steady flow: it has a chamber, or a part of it has no pressure, "
            "resistance or absorbing end that takes up any flow rate",
            "Set it to steady or given, or give the network such a terminal");
  input.network = network;
  for (const unsigned int c : at_network)
  {
    BoundaryCondition &condition = input.problem.conditions[c];
    Outlet outlet = *condition.outlet;
    outlet.network = network;
    condition.outlet = std::make_shared<const Outlet>(outlet);
  }
}

template <int dim>
void add_network_outlet(Case<dim> &input)
{
  if (!input.network)
    return;
  Outlet outlet;
  outlet.network = input.network;
  if (input.problem.interior.starts_under_mean_loads)
  {
    const auto in_mean = std::make_shared<NetworkParameters>(*input.network);
    in_mean->period_of_loads = input.periodic_state.period;
    outlet.network = in_mean;
  }
  for (const unsigned int c : conditions_at_network(input.problem))
  {
    BoundaryCondition &condition = input.problem.conditions[c];
    outlet.name += (outlet.name.empty() ? "" : " and ") + condition.name;
    outlet.coupling = condition.outlet->coupling;
    outlet.conditions.push_back(c);
    outlet.fractions.push_back(fraction_of_section(condition, *input.triangulation));
  }
  input.problem.outlets.push_back(outlet);
}

template <int dim>
std::vector<std::string> network_warnings(const Case<dim> &input)
{
  std::vector<std::string> warnings;
  if (!input.network)
    return warnings;
  const std::vector<unsigned int> at_network = conditions_at_network(input.problem);
  const auto fraction = [&](const unsigned int c)
  { return fraction_of_section(input.problem.conditions[c], *input.triangulation); };
  for (const unsigned int c : at_network)
  {
    const BoundaryCondition &condition = input.problem.conditions[c];
    if (const std::string text = warning_of_area(input, condition); !text.empty())
      warnings.push_back(text);
    const double first = fraction(at_network.front());
    if (!is_alike(first, fraction(c)))
      warnings.push_back("the mesh has " + six_digits(first) + " of the section at '" +
                         input.problem.conditions[at_network.front()].name + "' and " +
                         six_digits(fraction(c)) + " of that at '" + condition.name +
                         "': where vessels connect both, liquid is lost or made between them. "
                         "Mesh the same part of both");
  }
  return warnings;
}

template <int dim>
std::string network_at_start(const Case<dim> &input)
{
  if (!input.network)
    return "";
  const InteriorData &interior = input.problem.interior;
  if (interior.starts_steady_under_loads && input.network->has_steady_flow() &&
      (interior.starts_under_mean_loads || !input.network->gives_state_at_rest()))
    return "The network starts with its steady flow, under what the body gives it";
  if (interior.starts_steady_under_loads)
    return "The network starts at rest: what flows out of the body at t = 0 meets it as a jump";
  const unsigned int c = conditions_at_network(input.problem).front();
  const BoundaryCondition &condition = input.problem.conditions[c];
  double of_body = 0.;
  if (!interior.initial_pressure.empty())
    for (const auto &cell : input.triangulation->cell_iterators_on_level(0))
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == condition.boundary_id &&
            condition.region_ids.count(cell->material_id()) > 0)
          of_body = interior.initial_pressure[cell->material_id()](
              coordinates(cell->face(f)->center()).data(), 0.);
  const double of_network = input.network->initial_pressure;
  if (std::abs(of_network - of_body) <= least_jump * std::abs(of_network))
    return "";
  return "The network starts at t = 0 with a pressure of " + six_digits(of_network) +
         " Pa, the body at '" + condition.name + "' with " + six_digits(of_body) +
         " Pa: the body meets it as a jump, which the scheme starts with. 'Initial state/Pressure' "
         "and 'Network/Initial pressure' give both the same one";
}

template void read_network_of_body(Case<2> &, ParameterSection);
template void read_network_of_body(Case<3> &, ParameterSection);
template void add_network_outlet(Case<2> &);
template void add_network_outlet(Case<3> &);
template std::vector<std::string> network_warnings(const Case<2> &);
template std::vector<std::string> network_warnings(const Case<3> &);
template std::string network_at_start(const Case<2> &);
template std::string network_at_start(const Case<3> &);
} // namespace Continua
