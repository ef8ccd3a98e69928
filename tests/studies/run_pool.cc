// Runs side by side: how many at a time, how they end, and what a signal, a lack of memory and an
// error do. A shell script stands for the program.

#include <continua/base/input_error.h>
#include <continua/base/input_file.h>
#include <continua/base/interruption.h>
#include <continua/studies/run_pool.h>

#include "../unit_test.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace test_of_run_pool
{
using namespace Continua;

namespace
{
const std::string script = "./run-pool-test.sh", place = "run-pool-test";

/// Writes a program that notes how many of its kind are at work, does what stands in its parameter
/// file, and ends.
void write_script()
{
  std::filesystem::remove_all(place);
  std::filesystem::create_directory(place);
  std::ofstream(script) << "#!/bin/sh\n"
                           "cd "
                        << place
                        << "\n"
                           "mkdir at-work.$$\n"
                           "echo \"$*, launched $OMPI_COMM_WORLD_SIZE\" >> arguments\n"
                           "trap 'rmdir at-work.$$' EXIT\n"
                           "trap 'echo kept >> checkpoints; exit 1' TERM\n"
                           "ls -d at-work.* 2>/dev/null | wc -l >> counts\n"
                           "eval \"$2\"\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
}

PlannedRun run_of(const std::string &what_it_does, const double memory = 0.)
{
  PlannedRun plan;
  plan.command_line.parameter_file = what_it_does;
  plan.command_line.output_directory = "results";
  plan.memory = memory;
  return plan;
}

/// Performs the runs; why each failed.
std::vector<std::string> perform(
    const std::vector<PlannedRun> &plans,
    const unsigned int n_parallel,
    const RunPool::Begins &begins = [](unsigned int) {})
{
  std::vector<std::string> failures(plans.size(), "not ended");
  RunPool(n_parallel, script)
      .perform(plans, begins,
               [&failures](const unsigned int number, const std::string &failure)
               { failures[number] = failure; });
  return failures;
}

/// How many runs were at work as each one began, since the last call.
std::vector<int> counts_at_work()
{
  std::istringstream counts(read_input_file(place + "/counts"));
  std::filesystem::remove(place + "/counts");
  std::vector<int> result;
  for (int count = 0; counts >> count;)
    result.push_back(count);
  return result;
}

int most_at_work()
{
  const std::vector<int> counts = counts_at_work();
  return counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
}
} // namespace

UNIT_TEST(run_pool)
{
  const SignalWatch watch;
  write_script();
  ::setenv("OMPI_COMM_WORLD_SIZE", "2", 1);
  const std::vector<PlannedRun> slow(4, run_of("sleep 0.1"));
  check::is_true("all finish", perform(slow, 3) == std::vector<std::string>(4));
  check::is_true("three at a time", most_at_work() == 3);
  perform(slow, 1);
  check::is_true("one at a time", most_at_work() == 1);
  perform(std::vector<PlannedRun>(3, run_of("sleep 0.05", 1e18)), 3);
  check::is_true("not more than the memory holds", most_at_work() == 1);
  check::is_true("there is a core", RunPool::n_cores() > 0);

  const std::vector<std::string> failures = perform(
      {run_of("exit 0"), run_of("echo no; echo 'error: it diverges'; echo '  at 1 s'; exit 1"),
       run_of("echo one; echo 'the last'; exit 2"), run_of("exit 3"),
       run_of("rmdir at-work.$$; kill -9 $$")},
      2);
  check::equal("finished", failures[0], "");
  check::equal("its error", failures[1], "it diverges at 1 s");
  check::equal("its last words", failures[2], "the last");
  check::equal("without a word", failures[3], "it ended with the status 3");
  check::is_true("killed", check::matches(failures[4], "by the signal 'Killed', as by the system"));

  // What says nothing of the input is tried once more, alone.
  counts_at_work();
  std::vector<std::string> of_tries(3), of_first_tries(3);
  RunPool(3, script).perform(
      {run_of("[ -e killed ] && sleep 0.05 && exit 0; touch killed; rmdir at-work.$$; kill -9 $$"),
       run_of("[ -e lacks ] && sleep 0.05 && exit 0; touch lacks; echo 'error: MUMPS, "
              "factorisation: the "
              "memory of the machine is not enough (INFOG(1) = -13).'; exit 1"),
       run_of("echo tried >> always; echo 'error: the memory of the machine is not enough for this "
              "run.'; "
              "exit 1")},
      [](unsigned int) {},
      [&of_tries](const unsigned int number, const std::string &failure)
      { of_tries[number] += failure.empty() ? "finished" : failure; },
      [&of_first_tries](const unsigned int number, const std::string &failure)
      { of_first_tries[number] += failure; });
  check::equal("a run that was killed once", of_tries[0], "finished");
  check::equal("a run that had too little memory once", of_tries[1], "finished");
  check::equal("a run that has too little memory", of_tries[2],
               "it was tried twice, the second time alone: the memory of the machine is not enough "
               "for this run.");
  check::is_true("why the first is tried again",
                 check::matches(of_first_tries[0], "^it was ended by the signal 'Killed'"));
  check::equal("why the third is tried again", of_first_tries[2],
               "the memory of the machine is not enough for this run.");
  check::equal("its tries", read_input_file(place + "/always"), "tried\ntried\n");
  const std::vector<int> counts = counts_at_work();
  check::is_true("the second tries are alone",
                 counts.size() == 6 &&
                     std::vector<int>(counts.end() - 3, counts.end()) == std::vector<int>(3, 1));

  // A second try goes on from a checkpoint, but not from what a folder held before.
  const auto arguments_of_second_try = [](const bool overwrite)
  {
    std::filesystem::remove_all(place + "/results");
    std::filesystem::remove(place + "/arguments");
    PlannedRun killed = run_of("[ -e results ] && exit 0; mkdir -p results/checkpoint; touch "
                               "results/checkpoint/state; rmdir at-work.$$; kill -9 $$");
    killed.command_line.output_directory = place + "/results";
    killed.command_line.overwrite = overwrite;
    check::is_true("it finishes", perform({killed}, 2) == std::vector<std::string>(1));
    std::istringstream lines(read_input_file(place + "/arguments"));
    std::string first, second;
    std::getline(lines, first);
    std::getline(lines, second);
    return second;
  };
  std::string second = arguments_of_second_try(false);
  check::is_true("a second try from a checkpoint",
                 check::matches(second, "--restart") && !check::matches(second, "--overwrite"));
  second = arguments_of_second_try(true);
  check::is_true("a second try in a folder of another run",
                 check::matches(second, "--overwrite") && !check::matches(second, "--restart"));

  std::filesystem::remove(place + "/arguments");
  PlannedRun plan = run_of("exit 0");
  plan.command_line.overrides = {"A/B=--1", "C", "\"D=E\"=2"};
  plan.command_line.restart = true;
  plan.command_line.allow_mesh_commands = true;
  perform({plan}, 2);
  check::equal("arguments", read_input_file(place + "/arguments"),
               "--continua-internal-run-of-a-study=" + std::to_string(::getpid()) +
                   " exit 0 --set=A/B=--1 --unset=C --set=\"D=E\"=2 --output=results --restart "
                   "--allow-mesh-commands, launched \n");

  // What cannot be started has failed, and no more.
  std::vector<std::string> of_none;
  RunPool(2, "./run-pool-test-of-none")
      .perform(
          {run_of("exit 0"), run_of("exit 0")}, [](unsigned int) {},
          [&of_none](unsigned int, const std::string &failure) { of_none.push_back(failure); });
  check::is_true("no such program",
                 of_none.size() == 2 && check::matches(of_none[1], "cannot be started: No such"));

  // What throws ends the others, which may keep a checkpoint.
  const std::vector<PlannedRun> one_is_quick = {
      run_of("touch works; while :; do sleep 0.01; done"),
      run_of("while [ ! -e works ]; do sleep 0.01; done")};
  check::throws<RunError>(
      "an error at an end",
      [&one_is_quick]
      {
        RunPool(2, script).perform(
            one_is_quick, [](unsigned int) {},
            [](unsigned int, const std::string &) { throw RunError("enough"); });
      },
      "enough");
  check::is_true("the other one kept a checkpoint",
                 check::matches(read_input_file(place + "/checkpoints"), "kept"));
  std::filesystem::remove(place + "/checkpoints");

  // A signal goes to the runs, and no other begins.
  std::vector<PlannedRun> long_ones(3, run_of("touch begun; while :; do sleep 0.01; done"));
  unsigned int n_begun = 0;
  check::throws<Interrupted>(
      "a signal",
      [&]
      {
        perform(long_ones, 2,
                [&n_begun](unsigned int)
                {
                  // The first one has its trap once it works.
                  if (++n_begun == 2)
                  {
                    while (!std::filesystem::exists(place + "/begun"))
                      ;
                    ::raise(SIGTERM);
                  }
                });
      },
      "interrupted by SIGTERM among the runs.*--restart");
  check::is_true("two were begun", n_begun == 2);
  check::is_true("the first kept a checkpoint",
                 check::matches(read_input_file(place + "/checkpoints"), "kept"));

  char program[] = "continua", file[] = "a.prm";
  std::string mark = "--continua-internal-run-of-a-study=" + std::to_string(::getppid());
  static volatile std::sig_atomic_t n_terminations = 0;
  std::signal(SIGTERM, [](int) { n_terminations = n_terminations + 1; });
  std::vector<char *> arguments = {program, file};
  check::is_true("a command of a user", !is_run_of_a_pool(arguments) && arguments.size() == 2);
  arguments = {program, mark.data(), file};
  check::is_true("a run of a pool",
                 is_run_of_a_pool(arguments) && arguments.size() == 2 && arguments[1] == file);
  check::is_true("it works on", n_terminations == 0);
  mark = "--continua-internal-run-of-a-study=" + std::to_string(::getpid());
  arguments = {program, mark.data(), file};
  is_run_of_a_pool(arguments);
  check::is_true("it ends where its parent is gone", n_terminations == 1);
  std::filesystem::remove_all(place);
  std::filesystem::remove(script);
}
} // namespace test_of_run_pool
