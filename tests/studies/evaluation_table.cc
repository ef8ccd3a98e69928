// Evaluations of a fit on disk: what a restart knows, also after a line that a crash has cut.

#include <continua/studies/evaluation_table.h>

#include "../unit_test.h"

#include <deal.II/base/mpi.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace test_of_evaluation_table
{
using namespace Continua;

namespace
{
std::string content(const std::string &file)
{
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}
} // namespace

UNIT_TEST(evaluation_table)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string folder = "evaluations_of_the_test";
  std::filesystem::remove_all(folder);
  std::vector<FitParameter> parameters(2);
  parameters[0].name = "modulus";
  parameters[0].unit = "Pa";
  parameters[1].name = "clock, of one";
  parameters[1].unit = "s";
  {
    const OutputDirectory directory(folder, OutputDirectory::Mode::fresh, MPI_COMM_SELF);
    EvaluationTable table(directory, parameters, "case 1", false);
    check::is_true("nothing is known", table.known().empty());
    table.add({{1. / 3., 1e-7}, {{0.1, -2.5e-9, 3.}, ""}, 7.5, "start"});
    table.add({{2., 0.}, {{}, "the wall\nis gone"}, std::nan(""), "step"});
    table.add({{4., 0.}, {{1., 2., 3.}, ""}, 1., "step"});
  }
  check::equal("table", content(folder + "/evaluations.csv"),
               "evaluation [1],purpose,\"modulus [Pa]\",\"clock, of one [s]\",misfit [1],failure\n"
               "1,\"start\",0.3333333333333333,1e-07,7.5,\"\"\n"
               "2,\"step\",2,0,,\"the wall\nis gone\"\n"
               "3,\"step\",4,0,1,\"\"\n");
  const std::string checkpoint = folder + "/checkpoint/evaluations";
  check::equal("same case", EvaluationTable::why_not(checkpoint, "case 1"), "");
  check::is_true("other case",
                 check::matches(EvaluationTable::why_not(checkpoint, "case 2"), "another input"));
  check::is_true("no checkpoint", check::matches(EvaluationTable::why_not("nothing", "case 1"),
                                                 "nothing to go on from"));
  // The last line is cut.
  std::filesystem::resize_file(checkpoint, std::filesystem::file_size(checkpoint) - 3);
  const OutputDirectory directory(folder, OutputDirectory::Mode::restart, MPI_COMM_SELF);
  const EvaluationTable table(directory, parameters, "case 1", true);
  check::is_true("two are known", table.known().size() == 2);
  const Evaluation &first = table.known().front();
  check::is_true("to the last digit", first.set[0] == 1. / 3. && first.set[1] == 1e-7 &&
                                          first.prediction.values[1] == -2.5e-9 &&
                                          first.misfit == 7.5 && first.purpose == "start");
  check::equal("a failure", table.known().back().prediction.failure, "the wall is gone");
}
} // namespace test_of_evaluation_table
