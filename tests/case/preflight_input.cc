// What the pre-flight report is computed from: sizes of cells and ends of a tube as they stand in
// the file, the frequency of a pulse, the load's end first, and bodies that are no tubes.

#include "../parameter_text.h"
#include "tube_text.h"

#include <continua/case/before_the_run/preflight_input.h>
#include <continua/case/case.h>
#include <continua/program/analyses.h>

#include <deal.II/base/mpi.h>

#include "../unit_test.h"

namespace test_of_preflight_input
{
namespace
{
using namespace Continua;

PreflightInput input_of(const std::string &text)
{
  ParameterFile file = parameters_of(text);
  const Case<2> input = analyses().read_case<2>(file, MPI_COMM_WORLD);
  return preflight_input(input);
}
} // namespace

UNIT_TEST(preflight_input)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const PreflightInput tube = input_of(tube_text::tube(tube_text::pulse()));
  check::is_true("a tube", tube.is_tube && tube.regions.size() == 2);
  check::equal("regions", tube.regions[0].name + ", " + tube.regions[1].name, "fluid, wall");
  check::relative("largest cell of the liquid", tube.regions[0].largest_cell, 0.02, 1e-12);
  check::relative("its smallest", tube.regions[0].smallest_cell, 0.625e-3, 1e-12);
  check::relative("largest cell of the wall", tube.regions[1].largest_cell, 0.02, 1e-12);
  check::relative("its smallest one", tube.regions[1].smallest_cell, 0.5e-3, 1e-12);
  check::absolute("velocities along an edge", tube.velocities_per_cell, 2., 0.);
  check::relative("time step", tube.step.size(), 0.5e-3, 1e-14);
  check::is_true("Crank-Nicolson", tube.step.extrapolate);
  check::relative("end time", tube.end_time, 0.5, 1e-14);
  check::equal("load", tube.load, "inlet");
  // Of the energy of a sine squared pulse of duration T the part below about 0.95/T is told in the
  // tests of the load's spectrum.
  check::relative("its frequency", tube.frequency, 0.95 / 0.05, 0.1);
  check::is_true("it does not jump", !tube.load_jumps);
  // The end of the time cuts the pulse off within its rise: it keeps the frequency that it has in
  // the 80 ms in which it is over. (The shorter a record, the more of its mean is left out: 26 Hz.)
  const auto frequency_until = [](const std::string &end)
  {
    std::string text = tube_text::tube(tube_text::pulse());
    text.replace(text.find("0.5 s"), 5, end);
    return input_of(text).frequency;
  };
  check::relative("frequency of a load that is cut off", frequency_until("20 ms"),
                  frequency_until("80 ms"), 1e-3);
  check::relative("length", tube.length, 0.8, 1e-12);
  check::relative("along the axis", tube.axial_cell, 0.02, 1e-12);
  check::relative("at the wall", tube.normal_cell, 0.625e-3, 1e-12);
  for (unsigned int i = 0; i < 2; ++i)
  {
    const PreflightInput::End &end = tube.ends[i];
    const std::string name = i == 0 ? "near end: " : "far end: ";
    check::equal(name + "boundary", end.boundary, i == 0 ? "inlet" : "outlet");
    check::relative(name + "radius", end.section.inner_radius, 5e-3, 1e-12);
    check::relative(name + "wall", end.section.wall_thickness(), 1e-3, 1e-12);
    check::is_true(name + "what is given", end.flow_is_given == (i == 1) && !end.outlet &&
                                               end.wall_is_clamped && !end.section.tethered);
    check::relative(name + "its cell", end.wall_cell, 0.02, 1e-12);
  }

  // The load at the far end: that one comes first. Its jump.
  const PreflightInput turned = input_of(tube_text::tube(
      "set Type = fixed\n", "set Type = pressure\nset Pressure = if(t < 0.1, 1, 0)\n"));
  check::equal("turned: the load's end first",
               turned.ends[0].boundary + ", " + turned.ends[1].boundary, "outlet, inlet");
  check::is_true("turned: jumps", turned.load_jumps);
  // Held axially along the outside.
  const PreflightInput tethered = input_of(tube_text::tube(
      tube_text::pulse(), "set Type = resistance\nset Resistance = 5 MPa s/m^3\n",
      "set Type = free\n", "set Type = pressure\nset Pressure = 0\nset Tangential = fixed\n"));
  check::is_true("tethered", tethered.is_tube && tethered.ends[0].section.tethered);
  check::is_true("its free end with an outlet", !tethered.ends[1].wall_is_clamped &&
                                                    tethered.ends[1].outlet &&
                                                    !tethered.ends[1].flow_is_given);
  check::is_true("a rigid wall is none",
                 !input_of(tube_text::tube(tube_text::pulse(), "set Type = fixed\n",
                                           "set Type = fixed\n", "set Type = fixed\n"))
                      .is_tube);

  const std::string box = "set Analysis = transient\nset Model = plane strain\n"
                          "subsection Geometry\nset Type = box\nset Size = 4 m, 1 m\nend\n"
                          "subsection Mesh\nset Cells = 2, 1\nend\n"
                          "subsection Materials\nsubsection body\nset Type = hookean\n"
                          "set Density = 1\nset Young's modulus = 1\nset Poisson's ratio = 0.3\n"
                          "end\nend\nsubsection Boundaries\n"
                          "subsection left\nset Type = fixed\nend\n"
                          "subsection right\nset Type = free\nend\n"
                          "subsection bottom\nset Type = free\nend\n"
                          "subsection top\nset Type = free\nend\nend\n"
                          "subsection Time\nset Scheme = euler implicit\nset Time step = 0.1\n"
                          "set End time = 1\nend\n";
  const PreflightInput solid = input_of(box);
  check::is_true("a box is no tube", !solid.is_tube && solid.load.empty() && solid.frequency == 0.);
  check::relative("its cells", solid.regions[0].largest_cell + solid.regions[0].smallest_cell, 3.,
                  1e-12);
  ParameterFile of_tube = parameters_of(tube_text::tube(tube_text::pulse()));
  check::is_true("fluid and solid",
                 has_fluid_and_solid(analyses().read_case<2>(of_tube, MPI_COMM_WORLD)));
  ParameterFile of_box = parameters_of(box);
  check::is_true("a solid alone",
                 !has_fluid_and_solid(analyses().read_case<2>(of_box, MPI_COMM_WORLD)));
}
} // namespace test_of_preflight_input
