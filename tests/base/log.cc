// The lines on the screen and in log.txt; the progress line, on a pseudo-terminal.

#include <continua/base/input_error.h>
#include <continua/base/log.h>

#include "../unit_test.h"

#include <deal.II/base/mpi.h>

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace test_of_log
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

/// What a log prints on the screen while `function` runs.
std::string screen(const std::function<void()> &function)
{
  std::ostringstream text;
  std::streambuf *const before = std::cout.rdbuf(text.rdbuf());
  function();
  std::cout.rdbuf(before);
  return text.str();
}

std::string screen_of_terminal(const std::function<void()> &function)
{
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  grantpt(terminal);
  unlockpt(terminal);
  const int screen_end = open(ptsname(terminal), O_RDWR | O_NOCTTY);
  std::cout.flush();
  const int before = dup(STDOUT_FILENO);
  dup2(screen_end, STDOUT_FILENO);
  const std::string text = screen(function);
  dup2(before, STDOUT_FILENO);
  close(before);
  close(screen_end);
  close(terminal);
  return text;
}
} // namespace

UNIT_TEST(log)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  if (rank != 0)
  {
    // The other ranks call every method and must write nothing.
    Log log(MPI_COMM_WORLD);
    const std::string printed = screen(
        [&log]()
        {
          log.open("log-test-of-another-rank.txt", false);
          log.line("line");
          log.detail("detail");
          log.warning("warning");
          log.progress(0.5, 1., 1);
          log.end_progress();
          log.timing_summary();
        });
    if (!printed.empty() || std::filesystem::exists("log-test-of-another-rank.txt"))
      std::cout << "rank " << rank << " writes" << std::endl;
    return;
  }

  const std::string file = "log-test.txt";
  {
    std::ofstream(file) << "of an earlier run\n";
    Log log(MPI_COMM_WORLD);
    const std::string printed = screen(
        [&]()
        {
          log.line("before");
          log.detail("detail before");
          log.open(file, false);
          log.line("after");
          log.detail("two ranks");
          log.warning("slow");
          log.warning("odd");
          log.warning("slow");
        });
    check::equal("screen", printed, "before\nafter\nwarning: slow\nwarning: odd\n");
    check::equal("file at once", content(file),
                 "before\ndetail before\nafter\ntwo ranks\nwarning: slow\nwarning: odd\n");
    check::is_true("warnings", log.warnings() == std::vector<std::string>{"slow", "odd"});

    for (unsigned int i = 0; i < 2; ++i)
    {
      const SectionTimer::Scope scope(log.timer(), "assembly");
      usleep(10000);
    }
    const std::map<std::string, double> times = log.wall_times();
    check::is_true("wall times", times.size() == 2 && times.at("assembly") >= 0.02 &&
                                     times.at("total") >= times.at("assembly"));
    check::equal("the timer prints nothing", screen([&log]() { log.timing_summary(); }), "");
    check::is_true("times in the file",
                   check::matches(content(file), "assembly +[0-9.]+ s +[0-9.]+ %\n.*total"));
  }
  std::ofstream(file) << "first part\n";
  screen(
      [&]()
      {
        Log log(MPI_COMM_WORLD);
        log.open(file, true);
        log.line("restarted");
      });
  check::equal("appended", content(file), "first part\nrestarted\n");

  const auto steps = []()
  {
    Log log(MPI_COMM_WORLD);
    for (unsigned int step = 1; step <= 1000; ++step)
      log.progress(1. + 1e-3 * step, 2., step);
    log.line("done");
  };
  const int before = dup(STDOUT_FILENO);
  const int nowhere = open("/dev/null", O_WRONLY);
  std::cout.flush();
  dup2(nowhere, STDOUT_FILENO);
  const std::string off_terminal = screen(steps);
  dup2(before, STDOUT_FILENO);
  check::equal("no progress off a terminal", off_terminal, "done\n");

  const auto slow_steps = []()
  {
    // A report every 10 ms in place of one a minute.
    Log log(MPI_COMM_WORLD, true, 0.01);
    for (unsigned int step = 1; step <= 3; ++step)
    {
      log.progress(1. + 0.1 * step, 2., step);
      usleep(20000);
    }
  };
  std::ostringstream reports;
  std::streambuf *const errors = std::cerr.rdbuf(reports.rdbuf());
  dup2(nowhere, STDOUT_FILENO);
  const std::string beside_reports = screen(slow_steps);
  screen(steps);
  dup2(before, STDOUT_FILENO);
  std::cerr.rdbuf(errors);
  check::equal("reports are not on the output stream", beside_reports, "");
  check::is_true("remaining time off a terminal",
                 check::matches(reports.str(),
                                "^time 1.2 s of 2 s, step 2, [0-9.e+]+ steps/s, 0 s left\n"
                                "time 1.3 s of 2 s, step 3, [0-9.e+]+ steps/s, 0 s left\n$"));

  // Open MPI's launcher gives a terminal of its own to rank 0, which tells nothing of the user's.
  setenv("OMPI_COMM_WORLD_RANK", "0", 1);
  check::is_true("no progress under the launcher",
                 screen_of_terminal(steps).find("time") == std::string::npos);
  unsetenv("OMPI_COMM_WORLD_RANK");
  const std::string on_terminal = screen_of_terminal(steps);
  check::is_true("progress on a terminal",
                 check::matches(on_terminal, "\rtime 1.001 s of 2 s, step 1"));
  check::is_true("at most five a second",
                 on_terminal.find("step 2,") == std::string::npos && on_terminal.size() < 500);
  check::is_true("cleared before a line", on_terminal.find("\r\033[Kdone\n") != std::string::npos);
  const std::string remaining = screen_of_terminal(
      []()
      {
        Log log(MPI_COMM_WORLD);
        log.progress(0., 1., 0);
        usleep(210000);
        log.progress(0.5, 1., 10);
        log.end_progress();
      });
  check::is_true("rate and remaining time",
                 check::matches(remaining, "step 10, [0-9.]+ steps/s, [0-9]+ s left.*\r"));

  check::throws<RunError>(
      "no folder",
      []()
      {
        Log log(MPI_COMM_WORLD);
        log.open("no-such-folder/log.txt", false);
      },
      "no-such-folder/log.txt.*No such file");
  const std::string full = screen(
      []()
      {
        Log log(MPI_COMM_WORLD);
        log.open("/dev/full", false);
        log.line("one");
        log.line("two");
      });
  const std::string quiet = screen(
      [&file]()
      {
        Log log(MPI_COMM_WORLD, false);
        log.open(file, false);
        log.line("line");
        log.warning("slow");
      });
  check::equal("to the file alone", quiet + content(file), "line\nwarning: slow\n");
  check::equal("full disk", full,
               "one\nwarning: '/dev/full' cannot be written any more (is the disk full?); the "
               "lines go on here\ntwo\n");
  std::filesystem::remove(file);
}
} // namespace test_of_log
