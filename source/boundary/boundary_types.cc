#include <continua/boundary/boundary_types.h>

#include <continua/boundary/boundary_entries.h>
#include <continua/boundary/flow_rate_entries.h>
#include <continua/boundary/outlet_entries.h>

namespace Continua
{
namespace
{
using Kind = BoundaryPart::Kind;

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
  condition.volume_ratio = Waveform::read(
      section, "Volume ratio", Dimensions::none,
      "Volume that the boundary encloses, or that of the liquid behind it, "
      "over that in the undeformed mesh, such as 1 + 0.5*t; a function of time alone.",
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
                "undeformed shape: traction per undeformed area. " +
                    name + " to the undeformed boundary.",
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
} // namespace

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

void read_boundary_type(ParameterSection &section,
                        BoundaryCondition &condition,
                        const unsigned int dim)
{
  for (const Row &row : table())
    if (condition.type == row.type)
      row.read(section, condition, dim);
}
} // namespace Continua
