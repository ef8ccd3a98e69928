// A comparison goes on after a restart: what is finished stays, what is another case is run again.

#include <continua/base/input_error.h>
#include <continua/program/analyses.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "../unit_test.h"
#include "pulled_bar.h"

namespace test_of_comparison
{
using namespace Continua;

namespace
{
const std::string parameter_file = "comparison-test.prm", output = "comparison-test";

// By linear and quadratic velocities: exact in both.
const std::string text = "set Analysis = comparison\n" + std::string(pulled_bar) +
                         R"(subsection Comparison
  set Entry  = Finite element/Velocity degree
  set Values = 2, 3
  set Meshes = 0, 1
end
)";

/// Runs the comparison and returns what it prints.
std::string compare(CommandLine command_line, const OutputDirectory::Mode mode)
{
  command_line.parameter_file = parameter_file;
  command_line.restart = mode == OutputDirectory::Mode::restart;
  command_line.overwrite = mode == OutputDirectory::Mode::overwrite;
  std::ostringstream printed;
  std::streambuf *const screen = std::cout.rdbuf(printed.rdbuf());
  try
  {
    ParameterFile file(parameter_file, command_line.overrides);
    const std::unique_ptr<Analysis> comparison =
        analyses().make(file, command_line, MPI_COMM_WORLD);
    const OutputDirectory directory(output, mode, MPI_COMM_WORLD, file.input_files());
    Log log(MPI_COMM_WORLD);
    Summary summary;
    comparison->perform(directory, log, summary);
  }
  catch (const std::exception &)
  {
    std::cout.rdbuf(screen);
    throw;
  }
  std::cout.rdbuf(screen);
  return printed.str();
}

unsigned int count(const std::string &printed, const std::string &what)
{
  unsigned int n = 0;
  for (std::size_t at = printed.find(what); at != std::string::npos;
       at = printed.find(what, at + 1))
    ++n;
  return n;
}

CommandLine with(const std::string &override_text)
{
  CommandLine command_line;
  command_line.overrides = {override_text};
  return command_line;
}
} // namespace

UNIT_TEST(comparison)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::filesystem::remove_all(output);
  std::ofstream(parameter_file) << text;
  using Mode = OutputDirectory::Mode;
  const std::string again = ": was finished before\n", anew = ": finished\n";

  const std::string first = compare({}, Mode::fresh);
  check::is_true("four runs", count(first, anew) == 4 && count(first, again) == 0);
  // (1 - nu^2) / Y x 1 kPa x 2 m; linear over the bar, so that every mesh has it.
  check::is_true("their limit", count(first, "end: final displacement x [m]") == 1 &&
                                    count(first, "0.001875  round-off  settled") == 2);
  const std::string second = compare({}, Mode::restart);
  check::is_true("after a restart none is run", count(second, again) == 4);
  check::equal("and the tables are the same", second.substr(second.find("run ")),
               first.substr(first.find("run ")));
  const std::string more = compare(with("Comparison/Meshes=0,1,2"), Mode::restart);
  check::is_true("one more mesh", count(more, again) == 4 && count(more, anew) == 2);
  const std::string other = compare(with("Geometry/Size=2 m, 2 m"), Mode::restart);
  check::is_true("another case is run again", count(other, again) == 0 && count(other, anew) == 4);
  check::is_true("and then that one is finished",
                 count(compare(with("Geometry/Size=2 m, 2 m"), Mode::restart), again) == 4);
  check::is_true("the first case is not that of the folders any more",
                 count(compare({}, Mode::restart), anew) == 4 &&
                     count(compare(with("Geometry/Size=2 m, 2 m"), Mode::restart), anew) == 4);
  std::filesystem::remove(output + "/velocity-degree-3-1/summary.json");
  check::is_true("a run whose summary is gone is run again",
                 count(compare(with("Geometry/Size=2 m, 2 m"), Mode::restart), anew) == 1);
  check::is_true("an overwrite runs all", count(compare({}, Mode::overwrite), anew) == 4);
  check::throws<InputError>(
      "a folder with a run is kept", []() { compare({}, Mode::fresh); }, "holds a run");

  // The user's own entry gives way to that of the variant.
  const std::string mixed = compare(with(" Finite element / Velocity degree =4"), Mode::overwrite);
  check::is_true("an entry of the command line that is compared",
                 count(mixed, anew) == 4 && count(mixed, "velocity-degree-3-1: finished") == 1);
  std::filesystem::remove_all(output);
  std::filesystem::remove(parameter_file);
}
} // namespace test_of_comparison
