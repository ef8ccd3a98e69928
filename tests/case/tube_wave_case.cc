// What wave theory sees of a tube whose section varies: the uniform segments that stand for it, and
// how many of them are computed.

#include "../parameter_text.h"
#include "tube_text.h"

#include <continua/case/case.h>
#include <continua/case/tube_wave_case.h>
#include <continua/program/analyses.h>
#include <continua/vessel/tube_law.h>

#include <deal.II/base/mpi.h>

#include "../unit_test.h"

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
  check::is_true("by default more of both",
                 by_default.segments.size() > 7 && by_default.n_computed_sections > 5);
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
  check::relative("place of a station", backward.place(0.1), law.length() - 0.1, 1e-12);
  ParameterFile both = parameters_of(replaced(varying, "subsection outlet\nset Type = fixed\n",
                                              "subsection outlet\n" + tube_text::pulse()));
  const Case<2> loaded_twice = analyses().read_case<2>(both, MPI_COMM_WORLD);
  TubeWaveCase none;
  check::equal("loaded at both ends", make_tube_wave_case(loaded_twice, none),
               "both ends are loaded");

  check::throws<InputError>(
      "one segment for a varying tube",
      [&]() { problem_of(varying + "subsection Wave theory\nset Segments = 1\nend\n"); },
      "Segments");
}
