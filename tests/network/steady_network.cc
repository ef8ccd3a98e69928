// The steady flow in a network against closed forms: resistances in series and side by side, with
// Poiseuille's loss in vessels that are nearly rigid; a taper; loads over a period; that the
// network stays as it starts; and where there is none.

#include <continua/network/network_parameters.h>
#include <continua/network/steady_network.h>

#include "../parameter_text.h"
#include "../unit_test.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace test_of_steady_network
{
namespace
{
using namespace Continua;

constexpr double viscosity = 0.004, density = 1000.;

/// A network of which the node "joint" is at a body.
class AtBody
{
public:
  explicit AtBody(const std::string &sections)
      : parameters(read(sections)),
        network(parameters.make({[this](const double /*time*/) { return inflow; }})),
        node(parameters.node("joint")),
        steady(network, {node})
  {
  }

  double inflow = 0.; ///< [m^3/s]
  NetworkParameters parameters;
  Network network;
  unsigned int node;
  SteadyNetwork steady;

  double pressure_with(const double flow_rate, const SteadyNetwork::When &when = {})
  {
    inflow = flow_rate;
    steady.solve({flow_rate}, when);
    return steady.pressure(0);
  }
  /// By how much the pressure at the body moves away from where it starts, over its size.
  double drift(const double duration)
  {
    steady.start();
    const double before = network.end_pressure(node);
    double largest = 0.;
    for (unsigned int i = 1; i <= 20; ++i)
    {
      const double end = duration * i / 20.;
      const unsigned int n = std::isinf(network.largest_step())
                                 ? 1
                                 : std::ceil((end - network.time()) / network.largest_step() / 0.8);
      if (!network.advance_in(end, n))
        return 1.;
      largest = std::max(largest, std::abs(network.mean_pressure(node) - before));
    }
    return largest / std::abs(before);
  }

private:
  static NetworkParameters read(const std::string &sections)
  {
    ParameterFile file =
        parameters_of("subsection Network\nset Density = 1000 kg/m^3\nset Viscosity = 4 mPa s\n" +
                      sections + "end\n");
    NetworkParameters parameters;
    ParameterSection section = file.root().subsection("Network");
    parameters.nodes_at_body = {"joint"};
    parameters.read(section);
    parameters.read_materials(section, file.root().subsection("Materials"));
    parameters.check(section);
    return parameters;
  }
};

std::string vessel(const std::string &name,
                   const std::string &from,
                   const std::string &to,
                   const double radius_at_start,
                   const double radius_at_end,
                   const std::string &modulus = "10 GPa")
{
  return "subsection " + name + "\nset From = " + from + "\nset To = " + to +
         "\nset Length = 0.2 m\nset Radius at start = " + std::to_string(radius_at_start) +
         " mm\nset Radius at end = " + std::to_string(radius_at_end) +
         " mm\nset Wall thickness at start = 1 mm\nset Young's modulus = " + modulus + "\nend\n";
}

/// Poiseuille's [Pa s/m^3], of 0.2 m.
double resistance_of(const double radius_in_mm)
{
  return 8. * viscosity * 0.2 / (M_PI * std::pow(1e-3 * radius_in_mm, 4));
}

std::string windkessel(const std::string &node)
{
  return "subsection " + node + "\nset Type = windkessel\nset Proximal resistance = 8 MPa s/m^3\n" +
         "set Distal resistance = 120 MPa s/m^3\nset Compliance = 10 mm^3/Pa\n" +
         "set Pressure behind = 500 Pa\nend\n";
}

void in_series()
{
  AtBody end("subsection Vessels\n" + vessel("tube", "joint", "end", 5., 5.) +
             "end\nsubsection Terminals\n" + windkessel("end") + "end\n");
  const double flow = 1e-5, resistance = 128e6 + resistance_of(5.);
  check::relative("vessel and windkessel in series", end.pressure_with(flow),
                  500. + resistance * flow, 1e-6);
  check::relative("their derivative", end.steady.slope(0, 0), resistance, 1e-5);
  check::absolute("they stay so", end.drift(0.01), 0., 1e-9);
}

/// p + rho U^2/2 is the same at a fork: the pressures of the branches, in which the liquid is
/// slower or faster, are not.
void side_by_side()
{
  AtBody end("subsection Vessels\n" + vessel("trunk", "joint", "fork", 5., 5.) +
             vessel("first", "fork", "end", 4., 4.) + vessel("second", "fork", "open", 3., 3.) +
             "end\nsubsection Terminals\n" + windkessel("end") +
             "subsection open\nset Type = resistance\nset Resistance = 60 MPa s/m^3\n"
             "set Pressure behind = 500 Pa\nend\nend\n");
  const double flow = 2e-5, first = 128e6 + resistance_of(4.), second = 60e6 + resistance_of(3.);
  const auto dynamic = [](const double rate, const double radius_in_mm)
  { return 0.5 * density * std::pow(rate / (M_PI * std::pow(1e-3 * radius_in_mm, 2)), 2); };
  // The flow rate of the first one, by bisection.
  double low = 0., high = flow;
  for (unsigned int i = 0; i < 80; ++i)
  {
    const double q = 0.5 * (low + high);
    (first * q + dynamic(q, 4.) > second * (flow - q) + dynamic(flow - q, 3.) ? high : low) = q;
  }
  const double head = 500. + first * low + dynamic(low, 4.);
  check::relative("two vessels at a fork", end.pressure_with(flow),
                  head - dynamic(flow, 5.) + resistance_of(5.) * flow, 1e-6);
  check::absolute("they stay so", end.drift(0.01), 0., 1e-9);
}

/// A soft vessel whose radius changes: no closed form, but the finite volumes stay where it starts.
void soft_taper()
{
  AtBody end("set Initial pressure = 1000 Pa\nsubsection Vessels\n" +
             vessel("taper", "joint", "end", 5., 3.5, "400 kPa") + "end\nsubsection Terminals\n" +
             windkessel("end") + "end\n");
  end.pressure_with(1e-5);
  check::absolute("a soft taper stays so", end.drift(1.), 0., 1e-4);
}

void elements()
{
  AtBody end("subsection Elements\n"
             "subsection valve\nset Type = valve\nset From = joint\nset To = store\n"
             "set Resistance = 5 MPa s/m^3\nend\n"
             "subsection store\nset Type = compliance\nset Node = store\n"
             "set Compliance = 10 mm^3/Pa\nend\n"
             "subsection distal\nset Type = resistance\nset From = store\nset To = open\n"
             "set Resistance = 100 MPa s/m^3\nset Inertance = 1e5 kg/m^4\nend\nend\n"
             "subsection Terminals\nsubsection open\nset Type = pressure\n"
             "set Pressure = 1000*(1 + sin(2*pi*t))\nend\nend\n");
  check::is_true("behind a valve there is no flow back", !end.steady.exists());
  check::relative("elements in series, the mean of a load", end.pressure_with(1e-5, {0., 1.}),
                  1000. + 105e6 * 1e-5, 1e-9);
  check::relative("the load at a time", end.pressure_with(1e-5, {0.25, 0.}), 2000. + 105e6 * 1e-5,
                  1e-9);
  end.pressure_with(1e-5, {0., 0.});
  check::absolute("they start so", end.drift(1e-9), 0., 1e-9);
}

/// An open one has the same pressure on both sides, whichever way the liquid goes.
void valve_without_resistance()
{
  AtBody end(
      "subsection Elements\n"
      "subsection valve\nset Type = valve\nset From = joint\nset To = above\n"
      "set Resistance = 0\nset Inertance = 1e5 kg/m^4\nend\n"
      "subsection way out\nset Type = resistance\nset From = joint\nset To = below\n"
      "set Resistance = 100 MPa s/m^3\nend\nend\n"
      "subsection Terminals\nsubsection above\nset Type = pressure\nset Pressure = 2000\nend\n"
      "subsection below\nset Type = pressure\nset Pressure = 0\nend\nend\n");
  check::relative("a valve without a resistance is closed", end.pressure_with(1e-5), 1000., 1e-6);
  check::relative("and open", end.pressure_with(4e-5), 2000., 1e-9);
}

void where_there_is_none()
{
  const auto exists = [](const std::string &terminal)
  {
    return AtBody("subsection Vessels\n" + vessel("tube", "joint", "end", 5., 5.) +
                  "end\nsubsection Terminals\nsubsection end\n" + terminal + "end\nend\n")
        .steady.exists();
  };
  check::is_true("before a closed end", !exists("set Type = closed\n"));
  check::is_true("before a flow rate", !exists("set Type = flow rate\nset Flow rate = 0\n"));
  check::is_true("before a pressure", exists("set Type = pressure\nset Pressure = 0\n"));
  check::is_true("before an absorbing end", exists("set Type = absorbing\n"));
}
} // namespace

UNIT_TEST(steady_network)
{
  in_series();
  side_by_side();
  soft_taper();
  elements();
  valve_without_resistance();
  where_there_is_none();
}
} // namespace test_of_steady_network
