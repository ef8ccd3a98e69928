// What the numbers of a flow are computed from: pipes and channels, whole and in part, a lid, a
// flow rate in time, and pressures.

#include "../parameter_text.h"

#include <continua/case/before_the_run/flow_numbers_input.h>
#include <continua/program/analyses.h>

#include <deal.II/base/mpi.h>

#include "../unit_test.h"

namespace test_of_flow_numbers_input
{
namespace
{
using namespace Continua;

/// Boundaries by their entries, a line each.
using Entries = std::vector<std::pair<std::string, std::string>>;

std::string box(const std::string &model,
                const std::string &size,
                const std::string &cells,
                const Entries &boundaries,
                const std::string &more = "")
{
  std::string text = "set Analysis = transient\nset Model = " + model +
                     "\nset Convection = navier stokes\n"
                     "subsection Geometry\nset Type = box\nset Size = " +
                     size + "\nend\nsubsection Mesh\nset Cells = " + cells + "\n" + more +
                     "end\nsubsection Materials\nsubsection body\nset Type = newtonian\n"
                     "set Density = 1000 kg/m^3\nset Viscosity = 1 mPa s\n"
                     "set Bulk modulus = 2.25 GPa\nend\nend\nsubsection Boundaries\n";
  for (const auto &[name, entries] : boundaries)
    text += "subsection " + name + "\n" + entries + "\nend\n";
  return text + "end\nsubsection Time\nset Scheme = backward differencing\n"
                "set Update = implicit\nset Time step = 1 ms\nset End time = 1 s\nend\n";
}

template <int dim>
FlowNumbersInput flow_of(const std::string &text)
{
  ParameterFile file = parameters_of(text);
  const Case<dim> input = analyses().read_case<dim>(file, MPI_COMM_WORLD);
  return flow_numbers_input(input);
}
} // namespace

UNIT_TEST(flow_numbers_input)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using Duct = FlowNumbersInput::Duct;
  const std::string fixed = "set Type = fixed", roller = "set Type = roller",
                    open = "set Type = pressure\nset Pressure = 0 Pa", axis = "set Type = axis";
  // u = 6 U (y/H) (1 - y/H) with U = 2 m/s and H = 0.1 m.
  const std::string parabola = "set Type = velocity\nset Velocity = 12*y/0.1*(1 - y/0.1), 0";
  const FlowNumbersInput channel =
      flow_of<2>(box("plane strain", "1 m, 0.1 m", "10, 4",
                     {{"left", parabola}, {"right", open}, {"bottom", fixed}, {"top", fixed}},
                     "set Refinements = 1\n"));
  check::is_true("channel", channel.duct == Duct::channel && channel.boundary == "left" &&
                                channel.flows_in && !channel.has_absorbing_end);
  check::relative("channel: gap", channel.width, 0.1, 1e-12);
  check::relative("channel: mean speed", channel.mean_speed, 2., 1e-12);
  // At the point of a rule of 8 that is next to a vertex of the middle.
  check::relative("channel: largest speed", channel.largest_speed, 3., 1e-3);
  check::relative("channel: density and viscosity", channel.density / channel.viscosity, 1e6,
                  1e-12);
  check::relative("channel: longest cell", channel.largest_cell, 0.05, 1e-12);
  check::relative("channel: time step", channel.time_step, 1e-3, 1e-12);
  check::relative("channel: sound", channel.wave_speed, 1500., 1e-12);

  const FlowNumbersInput half =
      flow_of<2>(box("plane strain", "1 m, 0.1 m", "2, 2",
                     {{"left", "set Type = velocity\nset Velocity = 2*sin(2*pi*t), 0"},
                      {"right", open},
                      {"bottom", roller},
                      {"top", fixed}}));
  check::relative("half of a channel: gap", half.width, 0.2, 1e-12);
  check::relative("its largest mean speed in time", half.mean_speed, 2., 1e-12);
  check::relative("its shortest cell", half.shortest_cell, 0.5, 1e-12);

  const FlowNumbersInput pipe = flow_of<2>(
      box("axisymmetric", "0.1 m, 5 mm", "2, 2",
          {{"left", "set Type = flow rate\nset Flow rate = 7.853981633974483e-6*(1 + sin(2*pi*t))"},
           {"right", open},
           {"axis", axis},
           {"outside", fixed}}));
  check::is_true("pipe", pipe.duct == Duct::pipe);
  check::relative("pipe: diameter", pipe.width, 0.01, 1e-12);
  check::relative("pipe: mean speed", pipe.mean_speed, 0.2, 1e-12);
  check::relative("pipe: largest speed", pipe.largest_speed, 0.4, 1e-12);

  const FlowNumbersInput lid =
      flow_of<2>(box("plane strain", "2 m, 1 m", "2, 2",
                     {{"left", fixed},
                      {"right", fixed},
                      {"bottom", fixed},
                      {"top", "set Type = velocity\nset Velocity = 3, 0"}}));
  check::is_true("lid", lid.boundary == "top" && !lid.flows_in && lid.duct == Duct::none);
  check::relative("lid: speed", lid.mean_speed, 3., 1e-12);
  check::relative("lid: extent", lid.width, 2., 1e-12);

  const FlowNumbersInput pressure =
      flow_of<2>(box("plane strain", "1 m, 0.1 m", "2, 2",
                     {{"left", "set Type = pressure\nset Pressure = 1 Pa"},
                      {"right", open},
                      {"bottom", fixed},
                      {"top", fixed}}));
  check::is_true("pressures alone", pressure.boundary.empty() && pressure.duct == Duct::channel);
  check::relative("pressures alone: gap", pressure.width, 0.1, 1e-12);
  check::relative("pressures alone: density", pressure.density, 1000., 1e-12);

  // A square duct of 0.1 m, whole and by a quarter.
  const auto duct = [&](const std::string &size, const std::string &side)
  {
    return flow_of<3>(box("three-dimensional", size, "2, 2, 2",
                          {{"left", "set Type = velocity\nset Velocity = 1, 0, 0"},
                           {"right", open},
                           {"bottom", side},
                           {"top", fixed},
                           {"back", side},
                           {"front", fixed}}));
  };
  check::relative("square duct", duct("1 m, 0.1 m, 0.1 m", fixed).width, 0.1, 1e-12);
  check::relative("a quarter of it", duct("1 m, 0.05 m, 0.05 m", roller).width, 0.1, 1e-12);
}
} // namespace test_of_flow_numbers_input
