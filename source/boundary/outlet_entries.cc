#include <continua/boundary/outlet_entries.h>

#include <continua/base/required_entry.h>
#include <continua/boundary/boundary_entries.h>

#include <limits>
#include <memory>

namespace Continua
{
namespace
{
using Kind = BoundaryPart::Kind;

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
} // namespace

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
  section.add(
      "Node", condition.node,
      "Of the section Network: the loose end of a vessel, or a node of elements, which stands "
      "at this boundary. What flows out of the body flows into it, and its pressure acts on "
      "the body.");
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
} // namespace Continua
