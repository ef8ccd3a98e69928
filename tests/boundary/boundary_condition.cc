// Every type of boundary condition, conditions of one region, and what is refused.

#include <continua/boundary/boundary_conditions.h>
#include <continua/boundary/boundary_types.h>

#include "../parameter_text.h"
#include "../unit_test.h"

namespace test_of_boundary_condition
{
using namespace Continua;

namespace
{
using Kind = BoundaryPart::Kind;
const double place[3] = {2., 3., 0.};

/// Boundary 0 "inlet" touches region 0, boundary 1 "end" both regions.
std::vector<BoundaryCondition> read(const std::string &text, const bool axisymmetric = false)
{
  ParameterFile file = parameters_of(text);
  const auto conditions = read_boundary_conditions(file.root(), {"inlet", "end"}, {"fluid", "wall"},
                                                   {{0, 0}, {1, 0}, {1, 1}}, 2, axisymmetric);
  file.refuse_unknown();
  return conditions;
}
std::string child(const std::string &name, const std::string &entries)
{
  return "subsection " + name + "\n" + entries + "\nend\n";
}
BoundaryCondition inlet(const std::string &entries, const bool axisymmetric = false)
{
  return read(child("inlet", entries) + child("end", "set Type = free"), axisymmetric).front();
}
void refused(const std::string &name, const std::string &text, const std::string &pattern)
{
  check::throws<InputError>(
      name, [&] { read(text); }, "parameters_of_the_test.prm.*" + pattern);
}
} // namespace

UNIT_TEST(boundary_condition)
{
  const BoundaryCondition fixed = inlet("set Type = fixed");
  check::is_true("fixed", fixed.normal.kind == Kind::velocity && fixed.normal.is_zero() &&
                              fixed.tangential.kind == Kind::velocity &&
                              fixed.tangential.is_zero());
  check::is_true("names and ids", fixed.name == "inlet" && fixed.type == BoundaryType::fixed &&
                                      fixed.boundary_id == 0 &&
                                      fixed.region_ids == std::set<unsigned int>{0});
  const BoundaryCondition velocity = inlet("set Type = velocity\nset Velocity = 2 m/s, x*t");
  check::is_true("velocity", velocity.normal.kind == Kind::velocity &&
                                 velocity.tangential.kind == Kind::velocity &&
                                 velocity.normal.vector.size() == 2 &&
                                 velocity.normal.vector[1](place, 5.) == 10.);
  check::is_true("velocity: in time",
                 velocity.normal.depends_on_time() && !velocity.normal.is_zero());
  const BoundaryCondition traction = inlet("set Type = traction\nset Traction = 0, 1 MPa");
  check::is_true("traction", traction.normal.kind == Kind::traction &&
                                 traction.tangential.kind == Kind::traction &&
                                 traction.tangential.vector[1](place, 0.) == 1e6 &&
                                 !traction.normal.depends_on_time());
  const BoundaryCondition pressure = inlet("set Type = pressure\nset Pressure = 3 kPa");
  check::is_true("pressure", pressure.normal.kind == Kind::traction && pressure.normal.negative &&
                                 pressure.normal.along_normal(place, 0.) == 3000. &&
                                 pressure.tangential.kind == Kind::traction);
  check::is_true(
      "pressure with fixed tangential velocity",
      inlet("set Type = pressure\nset Pressure = 1\nset Tangential = fixed").tangential.kind ==
          Kind::velocity);
  const BoundaryCondition cavity = inlet("set Type = cavity\nset Volume ratio = 1 + 0.5*t");
  check::is_true("cavity", cavity.is_cavity() && cavity.volume_ratio(place, 2.) == 2. &&
                               cavity.normal.is_free() && cavity.tangential.is_free());
  check::is_true("other types are no cavity", !pressure.is_cavity());
  check::is_true("cavity that starts as it is", cavity.initial_jump(place).empty());
  check::is_true("cavity that starts with a jump",
                 inlet("set Type = cavity\nset Volume ratio = 1.1")
                         .initial_jump(place)
                         .find("a volume ratio of 1.1") != std::string::npos);
  const BoundaryCondition support = inlet(
      "set Type = support\nset Normal stiffness = 2 MPa/m\nset Tangential damping = 3 kPa s/m\n"
      "set Pressure = 4*t");
  check::is_true("support", support.is_supported() && support.normal.kind == Kind::traction &&
                                support.normal.stiffness == 2e6 && support.normal.damping == 0. &&
                                support.tangential.stiffness == 0. &&
                                support.tangential.damping == 3e3);
  check::is_true("support with a pressure",
                 support.normal.negative && support.normal.along_normal(place, 2.) == 8.);
  check::is_true("a support is not free",
                 !support.normal.is_free() && !support.tangential.is_free());
  check::is_true("other types have no support", !pressure.is_supported());
  const BoundaryCondition held =
      inlet("set Type = support\nset Normal damping = 1\nset Tangential = fixed");
  check::is_true("support that is held", held.tangential.is_fixed() && held.normal.damping == 1.);
  const BoundaryCondition flow = inlet("set Type = flow rate\nset Flow rate = 3 l/min", true);
  check::is_true("flow rate", flow.normal.kind == Kind::velocity && !flow.normal.is_zero() &&
                                  flow.tangential.kind == Kind::velocity &&
                                  flow.tangential.is_zero() &&
                                  flow.profile == FlowProfile::Shape::parabolic);
  check::relative("flow rate: value", flow.normal.along_normal(place, 0.), 5e-5, 1e-12);
  const BoundaryCondition in_plane = inlet("set Type = flow rate\nset Flow rate = 3 cm^2/s");
  check::is_true("flow rate of a channel", in_plane.is_in_plane && !flow.is_in_plane);
  check::relative("flow rate of a channel: value", in_plane.normal.along_normal(place, 0.), 3e-4,
                  1e-12);
  const BoundaryCondition pulsed =
      inlet("set Type = flow rate\nset Flow rate = 1\nset Profile = womersley\n"
            "set Flow before the start = periodic\nset Period = 0.8 s",
            true);
  check::is_true("periodic flow", pulsed.past == FlowPast::periodic && pulsed.period == 0.8);
  check::is_true("other types have no profile", !fixed.profile && !pressure.profile);
  const std::string windkessel_entries =
      "set Type = windkessel\nset Proximal resistance = 2 MPa s/m^3\n"
      "set Distal resistance = 1 mmHg s/ml\nset Compliance = 1.5 ml/mmHg\n";
  const BoundaryCondition resistance =
      inlet("set Type = resistance\nset Resistance = 3 MPa s/m^3\nset Pressure behind = 4*cos(t)");
  check::is_true("resistance", resistance.outlet && resistance.outlet->name == "inlet" &&
                                   resistance.outlet->coupling == Outlet::Coupling::pressure &&
                                   resistance.outlet->impedance.n_ports() == 1 &&
                                   resistance.outlet->impedance.direct(0, 0) == 3e6 &&
                                   resistance.outlet->impedance.terms.empty() &&
                                   resistance.outlet->pressure_behind(place, 0.) == 4.);
  check::is_true("resistance: a traction that is no load",
                 resistance.normal.kind == Kind::traction && resistance.normal.is_zero() &&
                     resistance.tangential.kind == Kind::traction && !resistance.profile);
  const BoundaryCondition windkessel = inlet(windkessel_entries + "set Tangential = fixed");
  const double mmhg = 13.5951 * 9.80665;
  check::is_true("windkessel", windkessel.outlet->impedance.direct(0, 0) == 2e6 &&
                                   windkessel.outlet->impedance.terms.size() == 1 &&
                                   windkessel.outlet->initial_states.empty() &&
                                   windkessel.tangential.kind == Kind::velocity);
  check::relative("windkessel: rate of 1/(R C)", windkessel.outlet->impedance.terms[0].rate,
                  1. / 1.5, 1e-12);
  check::relative("windkessel: its compliance", windkessel.outlet->impedance.terms[0].residue(0, 0),
                  mmhg / 1.5e-6, 1e-12);
  const BoundaryCondition charged =
      inlet(windkessel_entries + "set Initial pressure = 80 mmHg\nset Pressure behind = 5 mmHg");
  check::relative("windkessel: initial state", charged.outlet->initial_states[0], 75. * 1.5e-6,
                  1e-12);
  const BoundaryCondition by_flow =
      inlet(windkessel_entries + "set Coupling = flow\nset Profile = flat", true);
  check::is_true("windkessel that holds the flow",
                 by_flow.outlet->coupling == Outlet::Coupling::flow &&
                     by_flow.profile == FlowProfile::Shape::flat &&
                     by_flow.normal.kind == Kind::velocity &&
                     by_flow.tangential.kind == Kind::velocity && by_flow.normal.is_zero());
  const BoundaryCondition absorbing = inlet("set Type = absorbing");
  check::is_true("absorbing", absorbing.outlet && absorbing.outlet->impedance.n_ports() == 0 &&
                                  absorbing.normal.kind == Kind::traction);
  check::is_true("other types are no outlets", !fixed.outlet && !pressure.outlet);
  const BoundaryCondition roller = inlet("set Type = roller");
  check::is_true("roller", roller.normal.kind == Kind::velocity && roller.normal.is_zero() &&
                               roller.tangential.kind == Kind::traction);
  check::is_true("axis", inlet("set Type = axis", true).normal.kind == Kind::velocity);
  const BoundaryCondition free = inlet("set Type = free");
  check::is_true("free", free.normal.kind == Kind::traction && free.normal.is_zero() &&
                             free.tangential.kind == Kind::traction && free.tangential.is_zero());
  const BoundaryCondition mixed =
      inlet("set Type = mixed\nset Normal = velocity\nset Normal velocity = 2*t\n"
            "set Tangential = traction\nset Tangential traction = 1, 2");
  check::is_true("mixed: velocity and traction", mixed.normal.kind == Kind::velocity &&
                                                     mixed.normal.along_normal(place, 3.) == 6. &&
                                                     mixed.tangential.kind == Kind::traction &&
                                                     mixed.tangential.vector[1](place, 0.) == 2.);
  const BoundaryCondition sliding =
      inlet("set Type = mixed\nset Normal = pressure\nset Pressure = 5\n"
            "set Tangential = velocity\nset Tangential velocity = 0, 4");
  check::is_true("mixed: pressure and velocity", sliding.normal.negative &&
                                                     sliding.normal.along_normal(place, 0.) == 5. &&
                                                     sliding.tangential.kind == Kind::velocity);

  const auto two =
      read(child("inlet", "set Type = free") +
           child("fluid end", "set Boundary = end\nset Region = fluid\nset Type = fixed") +
           child("wall end", "set Boundary = end\nset Region = wall\nset Type = free"));
  check::is_true("one boundary, two regions", two.size() == 3 && two[1].boundary_id == 1 &&
                                                  two[1].region_ids == std::set<unsigned int>{0} &&
                                                  two[2].region_ids == std::set<unsigned int>{1});
  check::is_true("all types", boundary_types().size() >= 8);

  check::is_true("start: nothing", fixed.initial_jump(place).empty());
  const BoundaryCondition moving = inlet("set Type = velocity\nset Velocity = 3, 4*cos(t)");
  check::equal("start: velocity", moving.initial_jump(place),
               "The boundary 'inlet' starts at t = 0 with a velocity of 5 m/s: a body at rest "
               "meets it as a jump, which the scheme starts with; 'Ramp' makes a waveform rise "
               "smoothly from zero");
  check::is_true("start: pressure",
                 pressure.initial_jump(place).find("a pressure of 3000 Pa:") != std::string::npos);
  check::is_true("start: flow rate",
                 flow.initial_jump(place).find("a flow rate of 5e-05 m^3/s") != std::string::npos);
  check::is_true("start: pressure behind an outlet",
                 resistance.initial_jump(place).find("a pressure of 4 Pa:") != std::string::npos);
  check::is_true("start: a windkessel's initial pressure",
                 charged.initial_jump(place).find("a pressure of 10665.8 Pa:") !=
                     std::string::npos);
  check::is_true("start: an empty windkessel", windkessel.initial_jump(place).empty());
  check::is_true("start: ramp", inlet("set Type = pressure\nset Pressure = 3 kPa\nset Ramp = 1 ms")
                                    .initial_jump(place)
                                    .empty());

  const std::string end = child("end", "set Type = free");
  refused("missing", child("inlet", "set Type = free"),
          "the boundary 'end' has no condition in the region 'fluid'.*subsection end");
  refused("two on one boundary",
          child("inlet", "set Type = free") + end +
              child("again", "set Boundary = end\nset Region = wall\nset Type = fixed"),
          ":7: 'again'.*'end' of the region 'wall' has two conditions.*Keep one");
  refused("unknown boundary", child("outlet", "set Type = free") + end, ":1: 'outlet'.*inlet, end");
  refused("unknown region", child("inlet", "set Region = gel\nset Type = free") + end,
          ":2: 'inlet/Region'.*fluid, wall");
  refused("region that does not touch", child("inlet", "set Region = wall\nset Type = free") + end,
          ":2: 'inlet/Region'.*no face in the region 'wall'");
  refused("no type", child("inlet", "") + end, "'inlet'.*'Type' is missing");
  refused("unknown type", child("inlet", "set Type = open") + end, ":2: 'inlet/Type'.*fixed");
  refused("axis without axisymmetry", child("inlet", "set Type = axis") + end,
          ":2: 'inlet/Type'.*roller");
  refused("negative stiffness",
          child("inlet", "set Type = support\nset Normal stiffness = -1 Pa/m") + end,
          ":3: 'inlet/Normal stiffness'");
  refused("stiffness in another unit",
          child("inlet", "set Type = support\nset Normal stiffness = 1 Pa") + end,
          ":3: 'inlet/Normal stiffness'.*wrong unit");
  refused("damping in another unit",
          child("inlet", "set Type = support\nset Normal damping = 1 Pa/m") + end,
          ":3: 'inlet/Normal damping'.*wrong unit.*Pa s/m");
  refused("cavity without a volume", child("inlet", "set Type = cavity") + end, "Volume ratio");
  refused("cavity whose volume depends on place",
          child("inlet", "set Type = cavity\nset Volume ratio = x") + end,
          "Volume ratio.*depends on x, y or z");
  refused("support along a boundary that is held",
          child("inlet", "set Type = support\nset Normal stiffness = 1\nset Tangential = fixed\n"
                         "set Tangential stiffness = 1") +
              end,
          ":5: 'inlet/Tangential stiffness'.*Tangential = free");
  refused("flow rate of a plane model",
          child("inlet", "set Type = flow rate\nset Flow rate = 1 ml/s") + end,
          ":3: 'inlet/Flow rate'");
  refused("profile of another kind",
          child("inlet", "set Type = flow rate\nset Flow rate = 1\nset Period = 1 s") + end,
          ":4: 'inlet/Period'.*Profile = womersley only");
  refused("period of no periodic flow",
          child("inlet", "set Type = flow rate\nset Flow rate = 1\nset Profile = womersley\n"
                         "set Period = 1 s") +
              end,
          ":5: 'inlet/Period'.*Flow before the start = periodic only");
  refused("no table",
          child("inlet", "set Type = flow rate\nset Flow rate = 1\nset Profile = table") + end,
          "'Profile table' is missing");
  refused("negative resistance", child("inlet", "set Type = resistance\nset Resistance = -1") + end,
          ":3: 'inlet/Resistance'");
  refused("no resistance", child("inlet", "set Type = resistance") + end,
          "'inlet'.*'Resistance' is missing");
  refused("a resistance in another unit",
          child("inlet", "set Type = resistance\nset Resistance = 1 Pa s") + end,
          ":3: 'inlet/Resistance'.*wrong unit.*Pa s/m.3");
  refused("no compliance",
          child("inlet", "set Type = windkessel\nset Proximal resistance = 1\n"
                         "set Distal resistance = 1\nset Compliance = 0") +
              end,
          ":5: 'inlet/Compliance'");
  refused("pressure behind that depends on place",
          child("inlet", "set Type = resistance\nset Resistance = 1\nset Pressure behind = x") +
              end,
          ":4: 'inlet/Pressure behind'.*depends on x, y or z");
  refused("a profile without flow",
          child("inlet", "set Type = resistance\nset Resistance = 1\nset Profile = flat") + end,
          ":4: 'inlet/Profile'.*Coupling = flow");
  refused("a profile in a plane model",
          child("inlet", "set Type = resistance\nset Resistance = 1\nset Coupling = flow") + end,
          ":4: 'inlet/Coupling'.*plane model.*axisymmetric");
  check::throws<InputError>(
      "flow rate that depends on place",
      [] { inlet("set Type = flow rate\nset Flow rate = 1e-6*y", true); },
      ":3: 'inlet/Flow rate'.*depends on x, y or z.*Profile");
  refused("velocity missing", child("inlet", "set Type = velocity") + end,
          "'inlet'.*'Velocity' is missing");
  refused("three components in 2-D",
          child("inlet", "set Type = traction\nset Traction = 1, 2, 3") + end,
          ":3: 'inlet/Traction'");
  refused("wrong unit", child("inlet", "set Type = pressure\nset Pressure = 3 m") + end,
          ":3: 'inlet/Pressure'");
  refused("entry of another type", child("inlet", "set Type = fixed\nset Pressure = 3") + end,
          ":3: 'inlet/Pressure'");
}
} // namespace test_of_boundary_condition
