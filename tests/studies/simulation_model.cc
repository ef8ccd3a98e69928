// Runs as a model: their histories, runs that fail, and runs that a signal ends or that lack
// memory. A shell script stands for the program.

#include <continua/base/input_error.h>
#include <continua/base/interruption.h>
#include <continua/studies/simulation_model.h>

#include <deal.II/base/mpi.h>

#include "../unit_test.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace test_of_simulation_model
{
using namespace Continua;

namespace
{
const std::string script = "./simulation-model-test.sh", folder = "simulation-model-test",
                  file = "simulation-model-test.prm";

/// Its pressure rises by the entry Rate. With 2 the first run is killed, with 3 each of them; with
/// 6 the first one lacks memory.
void write_script()
{
  std::ofstream(script)
      << "#!/bin/sh\n"
         "for argument; do case $argument in\n"
         "--output=*) output=${argument#--output=};;\n"
         "--set=Rate=*) rate=${argument#--set=Rate=};;\n"
         "esac; done\n"
         "mkdir -p $output; echo $rate >> "
      << folder
      << "/begun\n"
         "[ $rate = 4 ] && { echo 'error: too soft'; exit 1; }\n"
         "[ $rate = 3 ] && kill -9 $$\n"
         "[ $rate = 6 ] && [ `grep -c 6 "
      << folder
      << "/begun` = 1 ] && { echo 'error: the memory of the machine is not enough for this run.'; "
         "exit 1; }\n"
         "[ $rate = 2 ] && [ `grep -c 2 "
      << folder
      << "/begun` = 1 ] && kill -9 $$\n"
         "{ echo 'time [s],other 0.1 m: pressure [Pa],stations 0.1 m: pressure [Pa]'\n"
         "for t in 0 1 2 3; do echo $t,7,$((t * rate)); done; } > "
         "$output/probes.csv\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  std::ofstream(file) << "set Rate = 1\n";
}

ForwardQuestion question(const std::string &rate)
{
  return {{{"Rate", rate}}, {{0.5, 2.}}};
}

double error_of(const ForwardAnswer &answer, const double rate)
{
  const std::vector<double> &pressure = answer.histories.at(0).at(0).at(0);
  return std::abs(pressure.at(0) - 0.5 * rate) + std::abs(pressure.at(1) - 2. * rate);
}
} // namespace

UNIT_TEST(simulation_model)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const SignalWatch watch;
  std::filesystem::remove_all(folder);
  write_script();
  CommandLine command_line;
  command_line.parameter_file = file;
  const OutputDirectory directory(folder, OutputDirectory::Mode::fresh, MPI_COMM_SELF);
  std::string warnings;
  SimulationModel model(
      command_line, directory, {{"stations", 1, {"pressure"}}}, 2, "run", 0.,
      [&warnings](const std::string &text) { warnings += text + "\n"; }, script);
  const auto answers = model.answers({question("5"), question("2"), question("4"), question("5")});
  check::absolute("histories", error_of(answers[0], 5.), 0., 1e-12);
  check::absolute("of a run that was killed once", error_of(answers[1], 2.), 0., 1e-12);
  check::is_true("a warning of it",
                 check::matches(warnings, "^run-2 is tried again, alone, when the others have "
                                          "ended: it was ended by the signal 'Killed'[^\n]*\n$"));
  check::equal("a run that failed", answers[2].failure, "too soft");
  check::absolute("the same entries again", error_of(answers[3], 5.), 0., 1e-12);
  check::is_true("folders of runs that ended well are gone",
                 !std::filesystem::exists(folder + "/run-1") &&
                     !std::filesystem::exists(folder + "/run-2"));
  check::is_true("that of the other one is there", std::filesystem::exists(folder + "/run-3"));
  model.answers({question("5"), question("4")});
  check::throws<RunError>(
      "killed twice", [&]() { model.answers({question("3")}); },
      "the run run-4: it was tried twice, the second time alone: it was ended by the signal "
      "'Killed'");
  check::absolute("of a run that lacked memory once",
                  error_of(model.answers({question("6")})[0], 6.), 0., 1e-12);
  std::ifstream begun(folder + "/begun");
  std::string rates;
  for (std::string rate; std::getline(begun, rate);)
    rates += rate;
  // Two at a time, so the processor chooses their order.
  std::sort(rates.begin(), rates.end());
  check::equal("runs that were begun", rates, "22334566");
}
} // namespace test_of_simulation_model
