// Names of folders, entries that are set over others, and a summary of runs of which some failed.

#include "../postprocess/text_file.h"

#include <continua/analysis/run_series.h>

#include <deal.II/base/mpi.h>

#include <filesystem>

#include "../unit_test.h"

using namespace Continua;

UNIT_TEST(run_series)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check::equal("folder", folder_name("Taylor hood"), "taylor-hood");
  check::equal("folder of a value", folder_name(" 0.4 ms, (2)"), "0-4-ms-2-");

  CommandLine command_line;
  command_line.parameter_file = "tube.prm";
  command_line.text = "continua tube.prm";
  command_line.overrides = {"Mesh/Axial  cells=10", "Time/Time step=1 ms",
                            " Mesh / Axial cells = 20"};
  set_entry(command_line, "Mesh/Axial cells", "40");
  check::is_true("an entry over all of the same name",
                 command_line.overrides ==
                     std::vector<std::string>{"Time/Time step=1 ms", "Mesh/Axial cells=40"});
  set_entry(command_line, "Analysis", "steady");
  check::equal("another one", command_line.overrides.back(), "Analysis=steady");

  RunResult first, second, third;
  first.name = "one";
  second.name = "two";
  second.failure = "it diverges";
  third.name = "three";
  third.failure = "no memory";
  Summary good;
  check::equal("none failed",
               begin_summary(good, "Title", "comparison", command_line, MPI_COMM_WORLD, {first}),
               "");
  good.write("run-series-test.json");
  check::is_true("its summary",
                 read_text("run-series-test.json").find("\"finished\"") != std::string::npos);
  Summary bad;
  check::equal("two failed",
               begin_summary(bad, "Title", "comparison", command_line, MPI_COMM_WORLD,
                             {first, second, third}),
               "two, three");
  bad.write("run-series-test.json");
  const std::string text = read_text("run-series-test.json");
  check::is_true("why", text.find("two: it diverges; three: no memory") != std::string::npos &&
                            text.find("\"failed\"") != std::string::npos);
  std::filesystem::remove("run-series-test.json");
}
