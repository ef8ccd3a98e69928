// What a file says of vessels and their ends: thick walls, materials, tables with a compliance of
// 0.

#include <continua/network/network_parameters.h>

#include <cmath>
#include <fstream>

#include "../parameter_text.h"
#include "../unit_test.h"

namespace test_of_network_parameters
{
using namespace Continua;

namespace
{
/// One vessel between a flow rate and a closed end, with further entries of the network and of the
/// vessel.
std::string
text_of(const std::string &of_network, const std::string &of_vessel, const std::string &at_end)
{
  return "subsection Network\nset Density = 1000 kg/m^3\nset Viscosity = 0 Pa s\n"
         "set End time = 1 s\n" +
         of_network +
         "subsection Vessels\nsubsection tube\nset From = a\nset To = b\nset Length = 1 m\n"
         "set Radius at start = 10 mm\nset Wall thickness at start = 4 mm\n" +
         of_vessel + "end\nend\n" +
         "subsection Terminals\nsubsection a\nset Type = flow rate\nset Flow rate = 1e-6\nend\n" +
         at_end + "end\nsubsection Stations\nsubsection s\nset Vessel = tube\nend\nend\nend\n" +
         (of_vessel.find("Material") == std::string::npos
              ? ""
              : "subsection Materials\nsubsection wall\nset Type = prony\nset Density = 1000 "
                "kg/m^3\nset Young's modulus = 400 kPa\nset Poisson's ratio = 0.5\nset Shear "
                "moduli "
                "= 40 kPa\nset Relaxation times = 0.1 s\nend\nend\n");
}

NetworkParameters read(const std::string &text)
{
  ParameterFile file = parameters_of(text);
  ParameterSection section = file.root().subsection("Network");
  NetworkParameters parameters;
  parameters.read(section);
  parameters.read_materials(file.root().subsection("Network"), file.root().subsection("Materials"));
  parameters.check(section);
  return parameters;
}

const std::string closed_end = "subsection b\nset Type = closed\nend\n";

/// dp/dA of a tube of Lame that is held along its axis: u = p R (1 + nu)/Y ((1 - 2 nu) R^2 + S^2)/
/// (S^2 - R^2), with the outer radius S.
void check_thick_wall()
{
  const double inner = 0.01, outer = 0.014, young = 4e5;
  for (const double nu : {0.5, 0.3})
  {
    Network network =
        read(text_of("set Wall theory = thick\nset Poisson's ratio = " + std::to_string(nu) + "\n",
                     "set Young's modulus = 400 kPa\n", closed_end))
            .make();
    const double area = FlowLaw::pi * inner * inner,
                 displacement = inner * (1. + nu) / young *
                                ((1. - 2. * nu) * inner * inner + outer * outer) /
                                (outer * outer - inner * inner); // of 1 Pa
    check::relative("thick wall, nu " + std::to_string(nu),
                    network.vessel(0).stiffness(Vessel::End::start, area),
                    1. / (2. * FlowLaw::pi * inner * displacement), 1e-12);
  }
}

void check_material()
{
  const NetworkParameters found = read(text_of("", "set Material = wall\n", closed_end));
  // mu = Y/3.
  check::relative("material: modulus", found.vessels[0].wall.youngs_modulus, 4e5, 1e-12);
  check::relative("material: share", found.vessels[0].wall.relaxation.branches.at(0).share, 0.3,
                  1e-12);
  check::is_true("material: the wall relaxes", found.make().vessel(0).wall_relaxes());
  const NetworkParameters own = read(
      text_of("set Relative moduli = 0.3\nset Relaxation times = 0.1 s\nset Damping time = 20 ms\n",
              "set Young's modulus = 400 kPa\n", closed_end));
  check::relative("own branch", own.vessels[0].wall.relaxation.branches.at(0).share, 0.3, 1e-12);
  check::relative("own damping", own.vessels[0].wall.relaxation.damping_time, 0.02, 1e-12);
}

/// A compliance of 0 leaves the sum of the resistances; the pressure behind is there, too.
void check_table()
{
  std::ofstream("terminals_of_the_test.csv") << "node, proximal resistance [MPa s/m^3], distal "
                                                "resistance [MPa s/m^3], compliance [m^3/Pa]\n"
                                                "b, 10, 90, 0\n";
  Network network =
      read(text_of("set Terminal table = terminals_of_the_test.csv\nset Pressure behind = 300 Pa\n",
                   "set Young's modulus = 400 kPa\n", ""))
          .make();
  network.advance(4., 0.8);
  const Vessel::State &state = network.vessel(0).end_state(Vessel::End::end);
  check::relative("compliance of 0: pressure",
                  network.vessel(0).pressure(Vessel::End::end, state.area), 300. + 1e8 * state.flow,
                  1e-9);
  check::relative("compliance of 0: flow rate", state.flow, 1e-6, 1e-3);
}
} // namespace

UNIT_TEST(network_parameters)
{
  check_thick_wall();
  check_material();
  check_table();
}
} // namespace test_of_network_parameters
