// Processes of our own: how they end, what they used, and that they end with their time.

#include <continua/base/child_process.h>
#include <continua/base/input_file.h>

#include "../unit_test.h"

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace test_of_child_process
{
using namespace Continua;

namespace
{
/// Processor time of the children that have ended [s].
double time_of_children()
{
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// The exit status of a shell command, with its screen in the file `screen`.
int status_of_shell(const std::string &command, const std::vector<std::string> &environment = {})
{
  ChildProcess::Program program;
  program.file = "/bin/sh";
  program.arguments = {"sh", "-c", command};
  program.environment = environment;
  program.screen = "screen";
  return ChildProcess(program).wait(60.).exit_status();
}

int status_of_copy(const std::function<int()> &function)
{
  return ChildProcess(function).wait(60.).exit_status();
}

bool is_there(const pid_t process)
{
  return ::kill(process, 0) == 0;
}
} // namespace

UNIT_TEST(child_process)
{
  check::is_true("status of a program", status_of_shell("exit 7") == 7);
  check::is_true("signal of a program", status_of_shell("kill -9 $$") == -SIGKILL);
  status_of_shell("echo one $NAME; echo two >&2", {"NAME=with environment"});
  check::equal("its screen", read_input_file("screen"), "one with environment\ntwo\n");
  ChildProcess::Program missing;
  missing.file = "/no/such/program";
  missing.screen = "screen";
  check::throws<std::runtime_error>(
      "a program that is not there", [&missing] { ChildProcess process(missing); },
      "cannot be started: No such file");

  check::is_true("status of a copy", status_of_copy([] { return 5; }) == 5);
  check::is_true("signal of a copy", status_of_copy([] { return ::raise(SIGTERM); }) == -SIGTERM);
  check::is_true("an error of a copy",
                 status_of_copy([]() -> int { throw std::runtime_error("wanted"); }) == 1);
  // What a copy changes is its own.
  int number = 1;
  status_of_copy([&number] { return ++number; });
  check::is_true("memory of a copy", number == 1);

  {
    const double before = time_of_children();
    ChildProcess busy(
        []
        {
          const std::clock_t start = std::clock();
          while (std::clock() - start < CLOCKS_PER_SEC / 2)
            ;
          return 0;
        });
    const ChildProcess::End end = busy.wait(600.);
    // What the system has counted of this process's children, of which no other one has ended.
    const double time = end.user_time + end.system_time;
    check::absolute("processor time", time, time_of_children() - before, 1e-3);
    check::is_true("processor time of the work", time > 0.4);
  }
  check::throws<std::runtime_error>(
      "the end of its time",
      []
      {
        ChildProcess(
            []
            {
              ::sleep(100);
              return 0;
            })
            .wait(0.05);
      },
      "did not end within 0.05 s");

  pid_t left = 0;
  {
    ChildProcess process(
        []
        {
          ::sleep(100);
          return 0;
        });
    left = process.number();
    check::is_true("it runs", !process.end() && is_there(left));
  }
  check::is_true("none is left", !is_there(left));

  ::setenv("OMPI_COMM_WORLD_SIZE", "3", 1);
  ::setenv("KEPT_OMPI", "1", 1);
  bool has_launcher = false, is_kept = false;
  for (const std::string &entry : environment_without_launcher())
  {
    has_launcher = has_launcher || entry == "OMPI_COMM_WORLD_SIZE=3";
    is_kept = is_kept || entry == "KEPT_OMPI=1";
  }
  check::is_true("the launcher's entries are left out", !has_launcher && is_kept);

  constexpr std::size_t limit = std::size_t(4) << 20;
  const auto writes = [](const std::size_t size)
  {
    const std::vector<char> block(size);
    std::FILE *const file = std::fopen("large", "wb");
    limit_this_process(limit);
    std::fwrite(block.data(), 1, block.size(), file);
    return std::fclose(file);
  };
  check::is_true("a file within the limit", status_of_copy([&] { return writes(limit / 2); }) == 0);
  check::is_true("a file beyond the limit",
                 status_of_copy([&] { return writes(2 * limit); }) == -SIGXFSZ);
}
} // namespace test_of_child_process
