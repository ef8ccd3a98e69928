// Names of folders, entries that are set over others, and a summary of runs of which some failed.

#include "../analysis/column_text.h"
#include "../parameter_text.h"
#include "../postprocess/text_file.h"

#include <continua/program/analyses.h>
#include <continua/studies/run_series.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <filesystem>

#include "../unit_test.h"

namespace test_of_run_series
{
using namespace Continua;

UNIT_TEST(run_series)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check::equal("folder", folder_name("Taylor hood"), "taylor-hood");
  check::equal("folder of a value", folder_name(" 0.4 ms, (2)"), "0-4-ms-2-");
  check::equal("folder of a number below zero", folder_name("size 2 -1.5e-3 m, (-.5)"),
               "size-2-minus-1-5e-3-m-minus-5-");
  check::equal("tidy path", tidy_path("A / \"B/C\"/ D  2"), "A/\"B/C\"/D 2");

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
  check::equal("none failed", set_status(good, {first}), "");
  good.write("run-series-test.json");
  check::is_true("its summary",
                 read_text("run-series-test.json").find("\"finished\"") != std::string::npos);
  Summary bad;
  check::equal("two failed", set_status(bad, {first, second, third}), "two, three");
  bad.write("run-series-test.json");
  const std::string text = read_text("run-series-test.json");
  check::is_true("why", text.find("two: it diverges; three: no memory") != std::string::npos &&
                            text.find("\"failed\"") != std::string::npos);
  std::filesystem::remove("run-series-test.json");

  // One run that fails between two that do not; the series goes on, and a restart takes what is
  // finished as it is.
  {
    parameters_of(column_text::column(
        "transient", "subsection Time\nset Time step = 20 us\nset End time = 80 us\nend\n"
                     "subsection Initial state\nset Velocity = sin(pi * x / 2), 0\nend\n"));
  }
  CommandLine series;
  series.parameter_file = parameter_file_of_the_test;
  series.overwrite = true;
  std::vector<PlannedRun> plans;
  for (const std::string limit : {"3 m/s", "0.5 m/s", "2 m/s"})
  {
    PlannedRun plan;
    plan.name = folder_name("limit " + limit);
    plan.command_line = series;
    plan.command_line.output_directory = "run_series/" + plan.name;
    set_entry(plan.command_line, "Time/Velocity limit", limit);
    plan.identity = limit;
    plans.push_back(plan);
  }
  Log log(MPI_COMM_WORLD, false);
  std::string finished;
  const auto perform = [&]()
  {
    finished = "";
    const OutputDirectory directory("run_series",
                                    series.restart ? OutputDirectory::Mode::restart
                                                   : OutputDirectory::Mode::overwrite,
                                    MPI_COMM_WORLD);
    return RunSeries(analyses(), MPI_COMM_WORLD, 2, series, {series.parameter_file}, 0.1)
        .perform(plans, directory, log,
                 [&finished](const RunResult &run, const unsigned int number)
                 { finished += std::to_string(number) + " " + run.name + "; "; });
  };
  const std::vector<RunResult> runs = perform();
  check::equal("runs that finished", finished, "0 limit-3-m-s; 2 limit-2-m-s; ");
  check::is_true("the other failed, with a reason",
                 runs.size() == 3 && runs[0].failure.empty() &&
                     check::matches(runs[1].failure, "0.5 m/s") && runs[2].failure.empty());
  check::absolute("cells", runs[0].n_cells, 10., 0.);
  check::relative("their size", runs[0].cell_size, 0.1, 1e-12);
  check::absolute("steps", runs[0].n_steps, 4., 0.);
  check::is_true("quantities", std::any_of(runs[2].quantities.begin(), runs[2].quantities.end(),
                                           [](const Quantity &entry)
                                           { return entry.name == "total energy change"; }));
  const auto written = std::filesystem::last_write_time("run_series/limit-3-m-s/summary.json");
  series.restart = true;
  plans[1].identity = "4 m/s";
  set_entry(plans[1].command_line, "Time/Velocity limit", "4 m/s");
  const std::vector<RunResult> again = perform();
  check::equal("all finish", finished, "0 limit-3-m-s; 1 limit-0-5-m-s; 2 limit-2-m-s; ");
  check::is_true("what was finished is taken as it was",
                 std::filesystem::last_write_time("run_series/limit-3-m-s/summary.json") ==
                         written &&
                     again[0].n_steps == 4.);
  // Results come from memory first, and then from the folder.
  bool equal = again[0].n_cells == runs[0].n_cells && again[0].n_dofs == runs[0].n_dofs &&
               again[0].wall_time == runs[0].wall_time && !runs[0].quantities.empty() &&
               again[0].quantities.size() == runs[0].quantities.size();
  for (std::size_t i = 0; equal && i < runs[0].quantities.size(); ++i)
  {
    const Quantity &first_time = runs[0].quantities[i], &taken = again[0].quantities[i];
    equal = first_time.name == taken.name && first_time.value == taken.value &&
            first_time.unit == taken.unit && first_time.probe == taken.probe;
  }
  check::is_true("it states the same, to all digits", equal);
}
} // namespace test_of_run_series
