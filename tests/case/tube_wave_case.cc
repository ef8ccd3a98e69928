// What wave theory sees of a tube whose section varies: the uniform segments that stand for it, and
// how many of them are computed.

#include "../parameter_text.h"
#include "tube_text.h"

#include <continua/case/case.h>
#include <continua/case/theory/tube_wave_case.h>
#include <continua/program/analyses.h>
#include <continua/vessel/tube_law.h>

#include <deal.II/base/mpi.h>

#include "../unit_test.h"

namespace test_of_tube_wave_case
{
namespace
{
using namespace Continua;

TubeWaveProblem problem_of(const std::string &text)
{
  ParameterFile file = parameters_of(text);
  const Case<2> input = analyses().read_case<2>(file, MPI_COMM_WORLD);
  TubeWaveCase wave_case;
  check::equal("covered", make_tube_wave_case(input, wave_case), "");
  return wave_case.problem;
}

std::string replaced(std::string text, const std::string &what, const std::string &by)
{
  text.replace(text.find(what), what.size(), by);
  return text;
}

/// An artery that divides, with a pressure pulse at the inlet. `outside`, `first_outlet`: the
/// entries of those boundaries.
std::string bifurcation(const std::string &outside, const std::string &first_outlet)
{
  std::string text =
      "set Analysis = transient\nset Model = three-dimensional\n"
      "subsection Geometry\nset Type = bifurcation\nset Parent length = 100 mm\n"
      "set Parent inner diameter = 6.2 mm\nset Parent wall thickness = 0.5 mm\n"
      "set First daughter length = 60 mm\nset First daughter inner diameter = 4.5 mm\n"
      "set First daughter wall thickness = 0.5 mm\nset First daughter angle = 25 deg\n"
      "set Second daughter length = 70 mm\nset Second daughter inner diameter = 3.5 mm\n"
      "set Second daughter wall thickness = 0.5 mm\nset Second daughter angle = 25 deg\nend\n"
      "subsection Materials\n"
      "subsection fluid\nset Type = newtonian\nset Density = 1000 kg/m^3\n"
      "set Bulk modulus = 2.2 GPa\nset Viscosity = 1 mPa s\nend\n"
      "subsection wall\nset Type = hookean\nset Density = 1100 kg/m^3\n"
      "set Young's modulus = 1.2 MPa\nset Poisson's ratio = 0.49\nend\nend\n"
      "subsection Boundaries\nsubsection inlet\n" +
      tube_text::pulse() + "end\nsubsection first outlet\n" + first_outlet +
      "end\nsubsection second outlet\nset Type = fixed\nend\nsubsection outside\n" + outside +
      "end\nsubsection side z\nset Type = roller\nend\n";
  for (const std::string end : {"inlet", "first outlet", "second outlet"})
    text += "subsection wall " + end + " end\nset Type = fixed\nend\n";
  return text + "end\nsubsection Time\nset Scheme = crank nicolson\nset Time step = 1 ms\n"
                "set End time = 10 ms\nend\n";
}
} // namespace

UNIT_TEST(tube_wave_case)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string uniform = tube_text::tube(tube_text::pulse());
  check::absolute("a uniform tube is one segment", problem_of(uniform).segments.size(), 1., 0.);

  // Tube E of the thesis: its diameter and its wall vary along it (appendix A).
  const std::string varying =
      replaced(uniform,
               "set Law = uniform\nset Inner diameter = 10 mm\nset Wall thickness = 1 mm\n"
               "set Length = 0.8 m\n",
               "set Law = E\n");
  const TubeWaveProblem by_default = problem_of(varying);
  const TubeWaveProblem problem = problem_of(
      varying + "subsection Wave theory\nset Segments = 7\nset Computed sections = 5\nend\n");
  check::absolute("segments", problem.segments.size(), 7., 0.);
  check::absolute("computed sections", problem.n_computed_sections, 5., 0.);
  check::relative("length", problem.length(), by_default.length(), 1e-13);
  check::is_true("by default 80 segments and 6 computed sections",
                 by_default.segments.size() == 80 && by_default.n_computed_sections == 6);
  const TubeLaw law = TubeLaw::thesis('E');
  check::is_true("it varies", law.inner_diameter(0.) > 1.5 * law.inner_diameter(law.length()));
  for (unsigned int i = 0; i < 7; ++i)
  {
    const double middle = (i + 0.5) / 7. * law.length();
    const TubeSection &section = problem.segments[i].section;
    check::relative("radius at the middle of segment " + std::to_string(i + 1),
                    section.inner_radius, 0.5 * law.inner_diameter(middle), 1e-12);
    check::relative("wall there", section.wall_thickness(), law.wall_thickness(middle), 1e-12);
  }

  // Loaded at the outlet the theory runs the other way: from the narrow end.
  ParameterFile file = parameters_of(replaced(
      varying,
      "subsection inlet\n" + tube_text::pulse() + "end\nsubsection outlet\nset Type = fixed\nend\n",
      "subsection inlet\nset Type = fixed\nend\nsubsection outlet\n" + tube_text::pulse() +
          "end\n"));
  const Case<2> input = analyses().read_case<2>(file, MPI_COMM_WORLD);
  TubeWaveCase backward;
  check::equal("loaded at the outlet", make_tube_wave_case(input, backward), "");
  check::is_true("from the outlet", backward.from_outlet && backward.direction() == -1.);
  check::is_true("narrow first", backward.problem.segments.front().section.inner_radius <
                                     backward.problem.segments.back().section.inner_radius);
  // Known without theory, too.
  ParameterFile forced =
      parameters_of(replaced(varying,
                             "subsection inlet\n" + tube_text::pulse() +
                                 "end\nsubsection outlet\nset Type = fixed\nend\n",
                             "subsection inlet\nset Type = fixed\nend\nsubsection outlet\n" +
                                 tube_text::pulse() + "end\n") +
                    "subsection Body force\nset Force density = 1, 0\nend\n");
  const Case<2> not_covered = analyses().read_case<2>(forced, MPI_COMM_WORLD);
  TubeWaveCase no_case;
  check::equal("with a body force", make_tube_wave_case(not_covered, no_case),
               "there is a body force");
  check::absolute("its direction", direction_of_pulse(not_covered, 0), -1., 0.);
  check::relative("place of a station", backward.place(0.1), law.length() - 0.1, 1e-12);
  ParameterFile both = parameters_of(replaced(varying, "subsection outlet\nset Type = fixed\n",
                                              "subsection outlet\n" + tube_text::pulse()));
  const Case<2> loaded_twice = analyses().read_case<2>(both, MPI_COMM_WORLD);
  TubeWaveCase none;
  check::equal("loaded at both ends", make_tube_wave_case(loaded_twice, none),
               "both ends are loaded");

  // A tube without a wall: one wave, and an outside that does not move.
  const auto without_wall = [&](const std::string &outside)
  {
    std::string text =
        tube_text::tube(tube_text::pulse(), "set Type = fixed\n", "set Type = fixed\n", outside);
    text = replaced(text, "set Wall thickness = 1 mm\n", "set Wall layers = none\n");
    text = replaced(text, "set Wall cells = 1\n", "");
    text = replaced(text, "subsection wall inlet end\nset Type = fixed\nend\n", "");
    text = replaced(text, "subsection wall outlet end\nset Type = fixed\nend\n", "");
    const std::size_t wall = text.find("subsection wall\n");
    return text.erase(wall, text.find("end\n", wall) + 4 - wall);
  };
  const TubeWaveProblem rigid = problem_of(without_wall("set Type = fixed\n"));
  check::is_true("rigid: no layers", rigid.segments.at(0).section.layers.empty());
  check::is_true("rigid: closed", rigid.outlet == TubeWaveProblem::Outlet::closed);
  {
    ParameterFile slipping = parameters_of(without_wall("set Type = roller\n"));
    const Case<2> read = analyses().read_case<2>(slipping, MPI_COMM_WORLD);
    TubeWaveCase not_covered;
    check::equal("rigid, outside that slips", make_tube_wave_case(read, not_covered),
                 "the tube has no wall, and its outside is not fixed");
  }

  // A vessel that divides: the parent, and the daughters as its branches.
  const std::string vessel = bifurcation("set Type = pressure\nset Pressure = 0 Pa\n"
                                         "set Tangential = fixed\n",
                                         "set Type = absorbing\n");
  const auto wave_case_of = [](const std::string &text, std::string &why_not)
  {
    ParameterFile parameters = parameters_of(text);
    const Case<3> read = analyses().read_case<3>(parameters, MPI_COMM_WORLD);
    TubeWaveCase result;
    why_not = make_tube_wave_case(read, result);
    return result.problem;
  };
  std::string why_not;
  const TubeWaveProblem divided = wave_case_of(vessel, why_not);
  check::equal("divided vessel", why_not, "");
  check::is_true("divides", divided.outlet == TubeWaveProblem::Outlet::divided);
  check::absolute("daughters", divided.branches.size(), 2., 0.);
  check::relative("length of the parent", divided.length(), 0.1, 1e-13);
  check::relative("length of the second", divided.branches[1].length(), 0.07, 1e-13);
  check::relative("radius of the second", divided.branches[1].segments[0].section.inner_radius,
                  1.75e-3, 1e-13);
  check::is_true("end of the first",
                 divided.branches[0].outlet == TubeWaveProblem::Outlet::absorbing);
  check::is_true("end of the second",
                 divided.branches[1].outlet == TubeWaveProblem::Outlet::closed);
  wave_case_of(bifurcation("set Type = free\n", "set Type = fixed\n"), why_not);
  check::equal(
      "divided, not held", why_not,
      "the vessel divides, and its wall is not held axially (outside: Tangential = fixed)");
  wave_case_of(replaced(vessel, "set Type = absorbing\n", tube_text::pulse()), why_not);
  check::equal("divided, loaded before and behind", why_not,
               "the vessel divides, and the 'first outlet' is loaded");
  const std::string loaded_behind =
      replaced(replaced(vessel, "subsection inlet\n" + tube_text::pulse(),
                        "subsection inlet\nset Type = fixed\n"),
               "set Type = absorbing\n", tube_text::pulse());
  wave_case_of(loaded_behind, why_not);
  check::equal("divided, loaded behind", why_not,
               "the inlet's Type is 'fixed', not pressure or flow rate");
  {
    ParameterFile text = parameters_of(loaded_behind), forward = parameters_of(vessel);
    const Case<3> behind = analyses().read_case<3>(text, MPI_COMM_WORLD),
                  before = analyses().read_case<3>(forward, MPI_COMM_WORLD);
    // Up the first daughter, up the parent, and down the second daughter.
    check::absolute("direction in the parent", direction_of_pulse(behind, 0), -1., 0.);
    check::absolute("in the first daughter", direction_of_pulse(behind, 1), -1., 0.);
    check::absolute("in the second daughter", direction_of_pulse(behind, 2), 1., 0.);
    for (unsigned int branch = 0; branch < 3; ++branch)
      check::absolute("loaded at the inlet", direction_of_pulse(before, branch), 1., 0.);
  }

  check::throws<InputError>(
      "one segment for a varying tube",
      [&]() { problem_of(varying + "subsection Wave theory\nset Segments = 1\nend\n"); },
      "Segments");
}
} // namespace test_of_tube_wave_case
