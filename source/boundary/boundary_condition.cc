#include <continua/boundary/boundary_condition.h>

#include <continua/base/joined.h>
#include <continua/base/parameter_file.h>
#include <continua/base/parameter_text.h>
#include <continua/base/quoted_name.h>
#include <continua/base/required_entry.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace Continua
{
namespace
{
using Kind = BoundaryPart::Kind;

/// Through a plane channel.
constexpr Dimension flow_rate_of_depth{0, 2, -1};
/// Traction over displacement, and over velocity.
constexpr Dimension support_stiffness{1, -2, -2}, support_damping{1, -2, -1};

void read_fixed(ParameterSection &, BoundaryCondition &condition, unsigned int)
{
  condition.normal.kind = condition.tangential.kind = Kind::velocity;
}

void read_velocity(ParameterSection &section, BoundaryCondition &condition, const unsigned int dim)
{
  condition.normal.kind = condition.tangential.kind = Kind::velocity;
  condition.normal.vector = condition.tangential.vector = Waveform::read_vector(
      section, "Velocity", dim, Dimensions::velocity, "Cartesian components of the velocity.");
}

void read_traction(ParameterSection &section, BoundaryCondition &condition, const unsigned int dim)
{
  condition.normal.vector = condition.tangential.vector = Waveform::read_vector(
      section, "Traction", dim, Dimensions::pressure,
      "Cartesian components of the traction n.sigma (force per area on the body).");
}

void read_tangential(ParameterSection &section, BoundaryCondition &condition)
{
  add_choice(section, "Tangential", condition.tangential.kind,
             {{"free", Kind::traction}, {"fixed", Kind::velocity}},
             "Along the boundary: free of traction, or fixed (no velocity along it).");
}

void read_inflow_pressure(ParameterSection &section,
                          BoundaryCondition &condition,
                          const InflowPressure by_itself)
{
  condition.inflow_pressure = by_itself;
  add_choice(section, "Inflow pressure", condition.inflow_pressure,
             {{"static", InflowPressure::static_pressure}, {"total", InflowPressure::total}},
             "What the boundary's pressure is where liquid flows in, with convection: static - the "
             "pressure of the liquid there; total - that and half of its density times the square "
             "of its velocity, which bounds the energy that flows back in through an outlet.");
}

void read_pressure(ParameterSection &section, BoundaryCondition &condition, unsigned int)
{
  condition.normal.along_normal =
      Waveform::read(section, "Pressure", Dimensions::pressure,
                     "Outside pressure: the normal traction is -p n.", true);
  condition.normal.negative = true;
  read_tangential(section, condition);
  read_inflow_pressure(section, condition, InflowPressure::static_pressure);
}

void read_cavity(ParameterSection &section, BoundaryCondition &condition, unsigned int)
{
  condition.volume_ratio = Waveform::read(section, "Volume ratio", Dimensions::none,
                                          "Volume that the boundary encloses, or that of the "
                                          "liquid behind it, over that in the mesh at "
                                          "rest, such as 1 + 0.5*t; a function of time alone.",
                                          true);
  if (condition.volume_ratio.depends_on_space())
    section.refuse("Volume ratio", "depends on x, y or z",
                   "Write it as a function of t: a cavity has one volume");
}

void read_support(ParameterSection &section, BoundaryCondition &condition, unsigned int)
{
  const auto read_part = [&section](const std::string &name, BoundaryPart &part)
  {
    section.add(name + " stiffness", part.stiffness, support_stiffness,
                "What the tissue around pushes back by, over the displacement of the body from its "
                "shape at rest: traction per area at rest. " +
                    name + " to the boundary at rest.",
                Range::not_negative());
    section.add(name + " damping", part.damping, support_damping,
                "The same over the velocity of the body.", Range::not_negative());
  };
  read_part("Normal", condition.normal);
  read_part("Tangential", condition.tangential);
  condition.normal.along_normal =
      Waveform::read(section, "Pressure", Dimensions::pressure,
                     "Outside pressure beside the support, as that of Type = pressure.", false);
  condition.normal.negative = true;
  read_tangential(section, condition);
  if (condition.tangential.kind == Kind::velocity)
    for (const char *const key : {"Tangential stiffness", "Tangential damping"})
      if (section.given(key))
        section.refuse(key, "with Tangential = fixed nothing moves along the boundary",
                       "Remove the entry, or set Tangential = free");
}

/// Entries of some profiles alone.
void refuse_other_profile(const ParameterSection &section,
                          const std::optional<FlowProfile::Shape> &profile,
                          const FlowProfile::Shape user,
                          const std::string &word,
                          const std::vector<std::string> &keys)
{
  for (const std::string &key : keys)
    if (profile != user && section.given(key))
      section.refuse(key, "is of use with Profile = " + word + " only",
                     "Set that, or remove the entry");
}

void read_profile_table(ParameterSection &section, BoundaryCondition &condition)
{
  std::string file, column;
  Interpolant::Kind kind = Interpolant::Kind::linear;
  section.add_input_file("Profile table", file,
                         "A csv file of the velocity over the distance from the centre, with a "
                         "header such as 'r [mm], U [m/s]'. It must cover the section.");
  section.require("Profile table");
  section.add("Profile column", column,
              "The column of the velocity; may be left out if there is but one.");
  add_choice(section, "Profile interpolation", kind,
             {{"linear", Interpolant::Kind::linear}, {"cubic", Interpolant::Kind::cubic}},
             "Between the rows; cubic is smooth and does not overshoot.");
  // Without a file the documentation of the entries is made.
  if (!file.empty())
    condition.profile_table = std::make_shared<const ProfileTable>(file, kind, column);
}

void read_flow_past(ParameterSection &section, BoundaryCondition &condition)
{
  add_choice(section, "Flow before the start", condition.past, flow_past_words(),
             "What the liquid of a womersley profile did before t = 0: at rest - nothing; steady - "
             "it carried the flow rate of t = 0; periodic - it carried the flow rate of 'Period' "
             "again and again, so that the flow is periodic from the start.");
  const bool is_periodic = condition.past == FlowPast::periodic;
  if (!is_periodic && section.given("Period"))
    section.refuse("Period", "is of use with Flow before the start = periodic only",
                   "Set that, or remove the entry");
  if (!is_periodic)
    return;
  double period = std::numeric_limits<double>::infinity();
  section.add("Period", period, Dimensions::time, "After which the flow rate repeats itself.",
              Range::positive());
  section.require("Period");
  condition.period = period;
}

void read_flow_rate(ParameterSection &section, BoundaryCondition &condition, unsigned int)
{
  using Shape = FlowProfile::Shape;
  const Waveform flow_rate =
      condition.is_in_plane
          ? Waveform::read(section, "Flow rate", flow_rate_of_depth,
                           "Flow rate of the whole channel and of a unit of its depth, into the "
                           "body; a function of time alone.",
                           true)
          : Waveform::read(section, "Flow rate", Dimensions::flow_rate,
                           "Flow rate of the whole tube, into the body; a function of time alone.",
                           true);
  if (flow_rate.depends_on_space())
    section.refuse(
        "Flow rate", "depends on x, y or z",
        "Write it as a function of t; 'Profile' gives the distribution over the section");
  // Without a shape it is free.
  std::optional<Shape> profile = Shape::parabolic;
  add_choice(section, "Profile", profile,
             {{"flat", Shape::flat},
              {"parabolic", Shape::parabolic},
              {"womersley", Shape::womersley},
              {"table", Shape::table},
              {"free", std::nullopt}},
             "How the velocity is distributed over the section: flat (zero at the rim), "
             "parabolic (the developed flow), womersley: that of a viscous liquid in a rigid tube "
             "or channel with this flow rate and 'Flow before the start', or table: as "
             "'Profile table' has it, scaled to the flow rate and zero at the rim. Or free, with "
             "Deformation = finite: as the equations have it, through a present section of any "
             "shape that may widen, on which one unknown pressure acts.");
  refuse_other_profile(section, profile, Shape::table, "table",
                       {"Profile table", "Profile column", "Profile interpolation"});
  refuse_other_profile(section, profile, Shape::womersley, "womersley",
                       {"Flow before the start", "Period"});
  if (profile == Shape::table)
    read_profile_table(section, condition);
  if (profile == Shape::womersley)
    read_flow_past(section, condition);
  if (!profile)
  {
    condition.free_flow = FreeFlow{flow_rate};
    read_tangential(section, condition);
    // With a static one the liquid that flows in can gain energy.
    read_inflow_pressure(section, condition, InflowPressure::total);
    return;
  }
  for (const char *const key : {"Tangential", "Inflow pressure"})
    if (section.given(key))
      section.refuse(key, "with this profile the velocity is given on all of the section",
                     "Remove the entry, or set Profile = free");
  condition.profile = profile;
  condition.normal.kind = condition.tangential.kind = Kind::velocity;
  condition.normal.along_normal = flow_rate;
}

/// How a section is held before what is behind it.
void read_coupling(ParameterSection &section, BoundaryCondition &condition, Outlet &outlet)
{
  outlet.name = condition.name;
  add_choice(section, "Coupling", outlet.coupling,
             {{"pressure", Outlet::Coupling::pressure}, {"flow", Outlet::Coupling::flow}},
             "How the section is held: pressure - one pressure acts on all of it, the "
             "velocity's distribution is free; flow - the velocity has the distribution of "
             "'Profile', of which only the flow rate is free.");
  FlowProfile::Shape profile = FlowProfile::Shape::parabolic;
  add_choice(section, "Profile", profile,
             {{"flat", FlowProfile::Shape::flat}, {"parabolic", FlowProfile::Shape::parabolic}},
             "How the velocity of Coupling = flow is distributed over the section: flat "
             "(zero at the rim) or parabolic.");
  read_tangential(section, condition);
  read_inflow_pressure(section, condition, InflowPressure::total);
  if (outlet.coupling == Outlet::Coupling::flow)
  {
    if (section.given("Inflow pressure"))
      section.refuse("Inflow pressure", "with Coupling = flow the velocity is held",
                     "Remove the entry, or set Coupling = pressure");
    if (section.given("Tangential") && condition.tangential.kind == Kind::traction)
      section.refuse("Tangential", "with Coupling = flow the section has no velocity along it",
                     "Remove the entry, or set Coupling = pressure");
    condition.normal.kind = condition.tangential.kind = Kind::velocity;
    condition.profile = profile;
  }
  else if (section.given("Profile"))
    section.refuse("Profile", "with Coupling = pressure the velocity's distribution is free",
                   "Remove the entry, or set Coupling = flow");
}

/// What a resistance and a windkessel have in common.
void read_outlet(ParameterSection &section, BoundaryCondition &condition, Outlet &outlet)
{
  outlet.pressure_behind =
      Waveform::read(section, "Pressure behind", Dimensions::pressure,
                     "Pressure into which the outlet flows; a function of time alone.", false);
  if (outlet.pressure_behind.depends_on_space())
    section.refuse("Pressure behind", "depends on x, y or z",
                   "Write it as a function of t: an outlet has one pressure");
  read_coupling(section, condition, outlet);
}

void read_resistance(ParameterSection &section, BoundaryCondition &condition, unsigned int)
{
  Outlet outlet;
  outlet.impedance = Impedance::resistance(required_entry(
      section, "Resistance", Dimensions::flow_resistance,
      "Pressure over the flow rate of the whole tube, out of the body.", Range::not_negative()));
  read_outlet(section, condition, outlet);
  condition.outlet = std::make_shared<const Outlet>(outlet);
}

void read_windkessel(ParameterSection &section, BoundaryCondition &condition, unsigned int)
{
  const double proximal_resistance = required_entry(
      section, "Proximal resistance", Dimensions::flow_resistance,
      "Resistance before the compliance, to the flow of the whole tube.", Range::not_negative());
  const double distal_resistance =
      required_entry(section, "Distal resistance", Dimensions::flow_resistance,
                     "Resistance beside the compliance.", Range::positive());
  const double compliance = required_entry(section, "Compliance", Dimensions::compliance,
                                           "Volume stored over pressure.", Range::positive());
  Outlet outlet;
  outlet.impedance = Impedance::windkessel(proximal_resistance, distal_resistance, compliance);
  read_outlet(section, condition, outlet);
  double initial_pressure = std::numeric_limits<double>::quiet_NaN();
  section.add("Initial pressure", initial_pressure, Dimensions::pressure,
              "Pressure of the compliance at t = 0, which a search for a steady state before it "
              "keeps; left "
              "out: the pressure behind, so that it is empty, and in a search for a steady state "
              "that of the "
              "steady flow.");
  if (section.given("Initial pressure"))
  {
    const double origin[3] = {0., 0., 0.};
    outlet.initial_states = {compliance *
                             (initial_pressure - outlet.pressure_behind.initial_value(origin))};
  }
  condition.outlet = std::make_shared<const Outlet>(outlet);
}

void read_network(ParameterSection &section, BoundaryCondition &condition, unsigned int)
{
  section.add("Node", condition.node,
              "Of the section Network: the loose end of a vessel, which stands at this boundary. "
              "What flows out of the body flows into it, and its pressure acts on the body.");
  section.require("Node");
  Outlet outlet;
  read_coupling(section, condition, outlet);
  condition.outlet = std::make_shared<const Outlet>(outlet);
}

void read_absorbing(ParameterSection &section, BoundaryCondition &condition, unsigned int)
{
  Outlet outlet;
  outlet.name = condition.name;
  condition.absorbing.read(section);
  if (condition.absorbing.has_mean_pressure)
  {
    outlet.pressure_behind = Waveform(condition.absorbing.mean_pressure);
    outlet.counts_from_start = true;
  }
  read_inflow_pressure(section, condition, InflowPressure::total);
  condition.outlet = std::make_shared<const Outlet>(outlet);
}

void read_roller(ParameterSection &, BoundaryCondition &condition, unsigned int)
{
  condition.normal.kind = Kind::velocity;
}

void read_free(ParameterSection &section, BoundaryCondition &condition, unsigned int)
{
  read_inflow_pressure(section, condition, InflowPressure::total);
}

void read_mixed(ParameterSection &section, BoundaryCondition &condition, const unsigned int dim)
{
  enum class Normal
  {
    velocity,
    pressure,
    traction
  };
  Normal normal = Normal::traction;
  add_choice(section, "Normal", normal,
             {{"velocity", Normal::velocity},
              {"pressure", Normal::pressure},
              {"traction", Normal::traction}},
             "What is given along the outward normal.");
  add_choice(section, "Tangential", condition.tangential.kind,
             {{"velocity", Kind::velocity}, {"traction", Kind::traction}},
             "What is given along the boundary.");
  if (normal == Normal::velocity)
  {
    condition.normal.kind = Kind::velocity;
    condition.normal.along_normal = Waveform::read(section, "Normal velocity", Dimensions::velocity,
                                                   "Velocity along the outward normal.", true);
  }
  else if (normal == Normal::pressure)
  {
    condition.normal.along_normal =
        Waveform::read(section, "Pressure", Dimensions::pressure,
                       "Outside pressure: the normal traction is -p n.", true);
    condition.normal.negative = true;
  }
  else
  {
    Expression value;
    add_expression(section, "Normal traction", value, Dimensions::pressure,
                   "Traction along the outward normal, positive when it pulls.");
    condition.normal.along_normal = Waveform(value);
  }
  if (condition.tangential.kind == Kind::velocity)
    condition.tangential.vector = Waveform::read_vector(
        section, "Tangential velocity", dim, Dimensions::velocity,
        "Cartesian components of a velocity, whose part along the boundary counts.", true,
        "Tangential");
  else
    condition.tangential.vector = Waveform::read_vector(
        section, "Tangential traction", dim, Dimensions::pressure,
        "Cartesian components of a traction, whose part along the boundary counts.", false,
        "Tangential");
}

struct Row
{
  BoundaryType type;
  const char *name;
  const char *description;
  void (*read)(ParameterSection &, BoundaryCondition &, unsigned int);
};

const std::vector<Row> &table()
{
  static const std::vector<Row> rows = {
      {BoundaryType::fixed, "fixed", "No velocity: normal and tangential velocity are zero.",
       read_fixed},
      {BoundaryType::velocity, "velocity", "Prescribed velocity, normal and tangential.",
       read_velocity},
      {BoundaryType::traction, "traction", "Prescribed traction, normal and tangential.",
       read_traction},
      {BoundaryType::pressure, "pressure",
       "Outside pressure along the normal; along the boundary free or fixed.", read_pressure},
      {BoundaryType::cavity, "cavity",
       "The surface of a cavity whose volume is given, or an opening of a body of liquid whose "
       "volume is, in finite deformation: one unknown pressure acts along the normal of the "
       "deformed boundary.",
       read_cavity},
      {BoundaryType::support, "support",
       "Tissue around a wall: springs and dampers push back where the wall moves, with an outside "
       "pressure if there is one.",
       read_support},
      {BoundaryType::flow_rate, "flow rate",
       "Flow rate into a round section, axisymmetric or three-dimensional, or into a plane "
       "channel; "
       "no velocity along the boundary. In finite deformation also into a section that moves.",
       read_flow_rate},
      {BoundaryType::resistance, "resistance",
       "An outlet of a liquid whose pressure follows its flow rate, p = R Q + pressure behind.",
       read_resistance},
      {BoundaryType::windkessel, "windkessel",
       "An outlet of a liquid into a resistance, behind which a compliance stores and a second "
       "resistance drains.",
       read_windkessel},
      {BoundaryType::network, "network",
       "An end of a liquid that goes on as a network of vessels in one dimension (section "
       "Network), with the same pressure and flow rate on both sides.",
       read_network},
      {BoundaryType::absorbing, "absorbing",
       "The end of a tube that goes on: the pressure follows the flow rate as its impedance says, "
       "so "
       "that waves leave; at the end of the wall the axial stress follows the axial velocity. "
       "Along "
       "the boundary there is no traction. Without a wall: the plane wave in a compressible "
       "liquid.",
       read_absorbing},
      {BoundaryType::roller, "roller",
       "No velocity along the normal, no traction along the boundary.", read_roller},
      {BoundaryType::axis, "axis", "The axis of an axisymmetric model: as roller.", read_roller},
      {BoundaryType::free, "free", "No traction, normal and tangential.", read_free},
      {BoundaryType::mixed, "mixed", "Any pair of a normal and a tangential part.", read_mixed}};
  return rows;
}

unsigned int index_of(const ParameterSection &section,
                      const std::string &key,
                      const std::string &what,
                      const std::string &name,
                      const std::vector<std::string> &names)
{
  auto place = std::find(names.begin(), names.end(), name);
  if (place == names.end())
    place = std::find(names.begin(), names.end(), without_quotes(collapse_blanks(name)));
  if (place == names.end())
    section.refuse(key, "the geometry has no " + what + " called '" + name + "'",
                   "It has: " + joined(names));
  return place - names.begin();
}
} // namespace

bool BoundaryPart::is_zero() const
{
  for (const Waveform &component : vector)
    if (!component.is_zero())
      return false;
  return along_normal.is_zero();
}

bool BoundaryPart::depends_on_time() const
{
  if (flow)
    return flow->depends_on_time();
  for (const Waveform &component : vector)
    if (component.depends_on_time())
      return true;
  return along_normal.depends_on_time();
}

std::vector<const Waveform *> BoundaryCondition::waveforms() const
{
  std::vector<const Waveform *> result;
  for (const BoundaryPart *part : {&normal, &tangential})
  {
    result.push_back(&part->along_normal);
    for (const Waveform &component : part->vector)
      result.push_back(&component);
  }
  if (is_cavity())
    result.push_back(&volume_ratio);
  if (free_flow)
    result.push_back(&free_flow->rate);
  if (outlet)
    result.push_back(&outlet->pressure_behind);
  return result;
}

std::vector<Waveform::Remark> BoundaryCondition::table_remarks(const double end_time) const
{
  return Waveform::table_remarks(waveforms(), "the boundary '" + name + "': ", end_time);
}

bool BoundaryCondition::table_begins_with_jump() const
{
  const std::vector<const Waveform *> all = waveforms();
  return std::any_of(all.begin(), all.end(),
                     [](const Waveform *one) { return one->table_begins_with_jump(); });
}

std::string BoundaryCondition::initial_jump(const double *point) const
{
  const std::string traction = "Pa", velocity = "m/s";
  std::vector<std::string> values;
  const auto add = [&](const std::string &what, const double value, const std::string &unit)
  {
    std::ostringstream text;
    text << what << " of " << value << ' ' << unit;
    if (value != 0. && std::find(values.begin(), values.end(), text.str()) == values.end())
      values.push_back(text.str());
  };
  for (const BoundaryPart *part : {&normal, &tangential})
  {
    const bool is_velocity = part->kind == Kind::velocity;
    double square = 0.;
    for (const Waveform &component : part->vector)
      square += std::pow(component.initial_value(point), 2);
    add(is_velocity ? "a velocity" : "a traction", std::sqrt(square),
        is_velocity ? velocity : traction);
    const double along = part->along_normal.initial_value(point);
    if (profile)
      add("a flow rate", along, is_in_plane ? "m^2/s" : "m^3/s");
    else if (part->negative)
      add("a pressure", along, traction);
    else
      add(is_velocity ? "a normal velocity" : "a normal traction", along,
          is_velocity ? velocity : traction);
  }
  if (const double ratio = volume_ratio.initial_value(point); is_cavity() && ratio != 1.)
    add("a volume ratio", ratio, "times the volume at rest");
  if (free_flow)
    add("a flow rate", free_flow->rate.initial_value(point), is_in_plane ? "m^2/s" : "m^3/s");
  if (outlet)
  {
    double pressure = outlet->pressure_behind.initial_value(point);
    for (unsigned int k = 0; k < outlet->initial_states.size(); ++k)
      pressure += outlet->impedance.terms[k].residue(0, 0) * outlet->initial_states[k];
    add("a pressure", pressure, traction);
  }
  if (values.empty())
    return "";
  return "The boundary '" + name + "' starts at t = 0 with " + joined(values) +
         ": a body at rest meets it as a jump, which the scheme starts with; 'Ramp' makes a "
         "waveform rise smoothly from zero";
}

std::vector<std::pair<std::string, std::string>> boundary_types()
{
  std::vector<std::pair<std::string, std::string>> types;
  for (const Row &row : table())
    types.emplace_back(row.name, row.description);
  return types;
}

const Words<BoundaryType> &boundary_type_words()
{
  static const Words<BoundaryType> words = []()
  {
    Words<BoundaryType> result;
    for (const Row &row : table())
      result.emplace_back(row.name, row.type);
    return result;
  }();
  return words;
}

std::set<std::string> boundaries_held_across(const ParameterFile &file)
{
  std::set<std::string> names;
  const ParameterText::Section *const section = file.text().find({"Boundaries"});
  if (section == nullptr)
    return names;
  for (const ParameterText::Section &child : section->sections)
  {
    const auto says = [&child](const char *const key, const std::vector<std::string> &words)
    {
      const ParameterText::Entry *const entry = child.entry(key);
      return entry != nullptr &&
             std::find(words.begin(), words.end(), entry->value()) != words.end();
    };
    const ParameterText::Entry *const boundary = child.entry("Boundary");
    if (says("Type", {"fixed", "velocity"}) ||
        (says("Type", {"flow rate"}) && !says("Profile", {"free"})) ||
        says("Tangential", {"fixed", "velocity"}) || says("Coupling", {"flow"}))
      names.insert(boundary != nullptr && !boundary->value().empty() ? boundary->value()
                                                                     : child.name);
  }
  return names;
}

bool some_mesh_follows(const ParameterFile &file)
{
  const ParameterText::Section *const section = file.text().find({"Boundaries"});
  return section != nullptr && std::any_of(section->sections.begin(), section->sections.end(),
                                           [](const ParameterText::Section &child)
                                           {
                                             const ParameterText::Entry *const entry =
                                                 child.entry("Mesh");
                                             return entry != nullptr && entry->value() == "follows";
                                           });
}

std::vector<BoundaryCondition>
read_boundary_conditions(ParameterSection section,
                         const std::vector<std::string> &boundaries,
                         const std::vector<std::string> &regions,
                         const std::set<std::pair<unsigned int, unsigned int>> &pairs,
                         const unsigned int n_dimensions,
                         const bool axisymmetric)
{
  std::string type_text = "What holds on the boundary; required.";
  for (const Row &row : table())
    type_text += std::string(" ") + row.name + " - " + row.description;

  std::vector<BoundaryCondition> conditions;
  std::map<std::pair<unsigned int, unsigned int>, std::string> taken;
  for (const std::string &child_name : section.subsections())
  {
    ParameterSection child = section.subsection(child_name);
    BoundaryCondition condition;
    condition.name = child_name;

    std::string boundary = child_name;
    child.add("Boundary", boundary,
              "Name of the boundary, where the subsection is not called after it (two conditions "
              "on the parts of one "
              "boundary that belong to different regions).");
    condition.boundary_id = index_of(child, child.given("Boundary") ? "Boundary" : "", "boundary",
                                     boundary, boundaries);

    std::string region;
    child.add("Region", region,
              "The one region whose part of the boundary is meant; empty: all of it.");
    for (const auto &pair : pairs)
      if (pair.first == condition.boundary_id &&
          (region.empty() || pair.second == index_of(child, "Region", "region", region, regions)))
        condition.region_ids.insert(pair.second);
    if (condition.region_ids.empty())
      child.refuse(region.empty() ? "" : "Region",
                   "the boundary '" + boundary + "' has no face" +
                       (region.empty() ? "" : " in the region '" + region + "'"),
                   "Remove the subsection, or name a region that touches the boundary");

    add_choice(child, "Type", condition.type, boundary_type_words(), type_text);
    child.require("Type");
    if (condition.type == BoundaryType::axis && !axisymmetric)
      child.refuse("Type", "there is no axis in this model",
                   "Use 'roller', or Model = axisymmetric");
    condition.is_in_plane = n_dimensions == 2 && !axisymmetric;
    for (const Row &row : table())
      if (condition.type == row.type)
        row.read(child, condition, n_dimensions);
    add_choice(
        child, "Mesh", condition.mesh,
        {{"automatic", MeshCondition::automatic},
         {"slides", MeshCondition::slides},
         {"fixed", MeshCondition::fixed},
         {"follows", MeshCondition::follows}},
        "What the mesh of a liquid does on the boundary with Deformation = finite, and on the "
        "cell-wise path with Mesh motion = elastic: "
        "slides - along a plane that is normal to an axis; fixed - it stays; follows - it "
        "moves with the velocity that is prescribed, or with 'Mesh velocity'; "
        "automatic - it slides on planes where the pressure or the traction is given, on "
        "outlets, on rollers and on the axis, and stays on walls, curved boundaries and "
        "where a velocity is given.");
    condition.mesh_velocity = Waveform::read_vector(
        child, "Mesh velocity", n_dimensions, Dimensions::velocity,
        "Of Mesh = follows: Cartesian components of the velocity of the mesh, where the liquid "
        "passes it; by itself the mesh has the velocity of the liquid. A formula has the place "
        "in the mesh at rest.",
        false, "Mesh");
    // Zeros that are given hold the mesh.
    const bool has_mesh_velocity =
        child.given("Mesh velocity") ||
        std::any_of(condition.mesh_velocity.begin(), condition.mesh_velocity.end(),
                    [](const Waveform &component) { return !component.is_zero(); });
    if (!has_mesh_velocity)
      condition.mesh_velocity.clear();
    else if (condition.mesh != MeshCondition::follows)
      child.refuse(child.given("Mesh velocity") ? "Mesh velocity" : "Mesh waveform",
                   "the mesh of the boundary does not follow",
                   "Set Mesh = follows, or leave the entry out");
    if (condition.mesh == MeshCondition::follows && condition.mesh_velocity.empty() &&
        (condition.normal.kind != BoundaryPart::Kind::velocity ||
         condition.tangential.kind != BoundaryPart::Kind::velocity))
      child.refuse("Mesh", "no velocity is prescribed here that the mesh would follow",
                   "Set Type = velocity, give a Mesh velocity, or set Mesh = slides or fixed");
    if (condition.outlet && condition.profile && n_dimensions == 2 && !axisymmetric)
      child.refuse("Coupling", "a plane model has no round section with a profile",
                   "Use Coupling = pressure, or Model = axisymmetric or three-dimensional");

    for (const unsigned int id : condition.region_ids)
    {
      const auto inserted = taken.insert({{condition.boundary_id, id}, child_name});
      if (!inserted.second)
        child.refuse("",
                     "the boundary '" + boundary + "' of the region '" + regions[id] +
                         "' has two conditions, here and in 'Boundaries/" + inserted.first->second +
                         "'",
                     "Keep one of the two");
    }
    conditions.push_back(condition);
  }
  for (const auto &pair : pairs)
    if (taken.count(pair) == 0)
      section.refuse_missing(
          "the boundary '" + boundaries[pair.first] + "' has no condition" +
              (regions.size() > 1 ? " in the region '" + regions[pair.second] + "'" : ""),
          "Add 'subsection " + quoted_name(boundaries[pair.first], "#") +
              "' with a Type (such as free) to Boundaries");
  return conditions;
}
} // namespace Continua
