// The table of analyses: each file goes to its row, and sections that a row does not read are
// refused with the name of the analysis that does.

#include "../parameter_text.h"

#include <continua/base/input_error.h>
#include <continua/program/analyses.h>

#include <deal.II/base/mpi.h>

#include <set>

#include "../unit_test.h"

namespace test_of_analyses
{
using namespace Continua;

namespace
{
/// A column that stands on a smooth floor.
std::string solid_box(const std::string &more)
{
  return more + "subsection Geometry\nset Type = box\nset Size = 1 m, 0.1 m\nend\n"
                "subsection Mesh\nset Cells = 2, 1\nend\n"
                "subsection Materials\nsubsection body\nset Type = hookean\n"
                "set Density = 1000 kg/m^3\nset Young's modulus = 1 MPa\n"
                "set Poisson's ratio = 0.3\nend\nend\n"
                "subsection Boundaries\nsubsection left\nset Type = fixed\nend\n"
                "subsection right\nset Type = free\nend\n"
                "subsection bottom\nset Type = roller\nend\n"
                "subsection top\nset Type = roller\nend\nend\n";
}

void make(const std::string &text)
{
  ParameterFile file = parameters_of(text);
  analyses().make(file, CommandLine(), MPI_COMM_WORLD);
}

bool has_checkpoints(const std::string &text)
{
  ParameterFile file = parameters_of(text);
  return analyses().make(file, CommandLine(), MPI_COMM_WORLD)->has_checkpoints();
}

const std::string section_time =
    "subsection Time\nset Time step = 1 ms\nset End time = 2 ms\nend\n";
} // namespace

UNIT_TEST(analyses)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::set<std::string> names;
  for (const AnalysisRow &row : analyses().rows())
  {
    names.insert(row.name);
    check::is_true(row.name, !row.description.empty() && row.make != nullptr &&
                                 !row.sections.empty() &&
                                 row.has_case() == (row.traits<3>().check != nullptr));
    if (row.has_case())
      check::equal(row.name + " in two and three dimensions",
                   row.traits<2>().name + ", " + row.traits<3>().name, row.name + ", " + row.name);
    check::equal(row.name + " is found", analyses().row(row.name).name, row.name);
  }
  check::absolute("names", names.size(), analyses().types().size(), 0.);

  check::is_true("a transient analysis has checkpoints", has_checkpoints(solid_box(section_time)));
  check::is_true("a modal one has none", !has_checkpoints(solid_box("set Analysis = modal\n")));
  check::throws<InputError>(
      "a section of one other analysis",
      []() { make(solid_box(section_time + "subsection Modal\nset Number of modes = 2\nend\n")); },
      "'Modal': Analysis = transient does not read this section. Remove it, or set Analysis = "
      "modal\\.$");
  check::throws<InputError>(
      "a section of several", []() { make(solid_box("set Analysis = steady\n" + section_time)); },
      "'Time': Analysis = steady does not read.*transient or periodic response or pulse response "
      "or linear wave theory or material\\.$");
  check::throws<InputError>(
      "a study of what has no case",
      []() { make("set Analysis = spin coating\nsubsection Comparison\nset Runs = a\nend\n"); },
      "'Comparison': Analysis = spin coating does not read.*Analysis = comparison\\.$");

  // The file of a study may be run alone; its section is read then, too.
  const std::string study = "subsection Refinement study\nset Cycles = 1\nend\n";
  ParameterFile alone = parameters_of(solid_box(section_time + study));
  const Case<2> transient = analyses().read_case<2>(alone, MPI_COMM_WORLD);
  check::is_true("a run of a study", transient.analysis.is_transient());
  ParameterFile of_study = parameters_of(solid_box("set Analysis = refinement study\n" + study));
  const Case<2> steady = analyses().read_case<2>(of_study, MPI_COMM_WORLD, CaseUse::run, "steady");
  check::equal("its case", steady.general.analysis, "steady");
  check::is_true("its motion", steady.analysis.is_steady() && !steady.analysis.has_checkpoints);
  check::throws<InputError>(
      "a wrong entry of it",
      []()
      { make(solid_box(section_time + "subsection Refinement study\nset Cycles = 0\nend\n")); },
      "Refinement study/Cycles");
}
} // namespace test_of_analyses
