#include <continua/studies/run_pool.h>

#include <continua/base/child_process.h>
#include <continua/base/input_error.h>
#include <continua/base/input_file.h>
#include <continua/base/interruption.h>
#include <continua/base/lack_of_memory.h>
#include <continua/base/memory_limit.h>
#include <continua/base/output_directory.h>
#include <continua/base/parameter_text.h>

#include <sched.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <list>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

namespace Continua
{
namespace
{
/// Behind it stands the number of the process that starts the run.
const std::string mark_of_a_run = "--continua-internal-run-of-a-study=";
const std::string ended_by_signal = "it was ended by the signal";
/// What runs get to end by themselves where this process cannot go on.
constexpr std::chrono::seconds time_to_end(30);

/// For what the runs print: each has a log of its own, and nobody sees their screens.
class FolderOfScreens
{
public:
  FolderOfScreens()
  {
    std::string name = (std::filesystem::temp_directory_path() / "continua-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw RunError("no folder can be made in " + std::filesystem::temp_directory_path().string() +
                     ": " + std::strerror(errno));
    path = name;
  }
  ~FolderOfScreens()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  FolderOfScreens(const FolderOfScreens &) = delete;
  FolderOfScreens &operator=(const FolderOfScreens &) = delete;

  std::string file(const unsigned int number) const
  {
    return (path / std::to_string(number)).string();
  }

private:
  std::filesystem::path path;
};

/// A run at work.
struct RunningRun
{
  unsigned int number;
  double memory;
  std::unique_ptr<ChildProcess> process;
};

/// The runs at work. What an error leaves gets SIGTERM, so that it keeps a checkpoint, and time for
/// it.
class RunningRuns : public std::list<RunningRun>
{
public:
  RunningRuns() = default;
  ~RunningRuns()
  {
    send(SIGTERM);
    const auto deadline = std::chrono::steady_clock::now() + time_to_end;
    while (!empty() && std::chrono::steady_clock::now() < deadline)
    {
      remove_if([](const RunningRun &run) { return has_ended(*run.process); });
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  RunningRuns(const RunningRuns &) = delete;
  RunningRuns &operator=(const RunningRuns &) = delete;

  void send(const int signal) const
  {
    for (const RunningRun &run : *this)
      ::kill(run.process->number(), signal);
  }

private:
  static bool has_ended(ChildProcess &process)
  {
    try
    {
      return process.end().has_value();
    }
    catch (const std::exception &)
    {
      return true; // it was lost
    }
  }
};

/// What the run said last: its error with all that follows, or its last line.
std::string last_words(const std::string &screen)
{
  const std::string beginning = "error: ";
  std::string text = "\n" + read_input_file(screen);
  if (const std::size_t error = text.rfind("\n" + beginning); error != std::string::npos)
    return collapse_blanks(text.substr(error + 1 + beginning.size()));
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (!collapse_blanks(line).empty())
      last = collapse_blanks(line);
  return last;
}

/// Why a run failed; empty if it finished.
std::string failure_of(const int status, const std::string &screen)
{
  if (status == 0)
    return "";
  const std::string said = last_words(screen);
  if (status > 0)
    return said.empty() ? "it ended with the status " + std::to_string(status) : said;
  return ended_by_signal + " '" + std::string(::strsignal(-status)) + "'" +
         (status == -SIGKILL ? ", as by the system where memory is at its end" : "") +
         (said.empty() ? "" : "; it said last: " + said);
}

/// Why the run failed, empty if it finished; nothing while it runs.
std::optional<std::string> end_of(const RunningRun &run, const std::string &screen)
{
  try
  {
    if (const auto end = run.process->end())
      return failure_of(end->exit_status(), screen);
    return {};
  }
  catch (const std::exception &error)
  {
    return error.what();
  }
}

std::unique_ptr<ChildProcess>
start(const std::string &program, const PlannedRun &plan, const std::string &screen)
{
  ChildProcess::Program run;
  run.file = program;
  run.arguments = {"continua", mark_of_a_run + std::to_string(::getpid())};
  for (const std::string &argument : arguments_of(plan.command_line))
    run.arguments.push_back(argument);
  run.environment = environment_without_launcher();
  run.screen = screen;
  return std::make_unique<ChildProcess>(run);
}
} // namespace

const std::string among_runs =
    "among the runs of the study; --restart goes on with those that are not finished";

bool says_nothing_of_input(const std::string &failure)
{
  return failure.find(ended_by_signal) != std::string::npos ||
         failure.find(lack_of_memory) != std::string::npos;
}

RunPool::RunPool(const unsigned int n_parallel, std::string program)
    : n_parallel(std::max(n_parallel, 1u)), program(std::move(program))
{
}

void RunPool::perform(const std::vector<PlannedRun> &plans,
                      const Begins &begins,
                      const Ended &ended,
                      const Again &again_of) const
{
  std::vector<PlannedRun> again;
  std::vector<unsigned int> numbers; // of these
  perform_once(plans, n_parallel, begins,
               [&](const unsigned int number, const std::string &failure)
               {
                 if (!says_nothing_of_input(failure))
                   return ended(number, failure);
                 again_of(number, failure);
                 again.push_back(plans[number]);
                 CommandLine &command_line = again.back().command_line;
                 // What it has kept is not computed again; but the checkpoint in a folder that it
                 // was to empty may be of another run.
                 command_line.restart =
                     !command_line.overwrite &&
                     OutputDirectory::has_checkpoint(command_line.output_directory);
                 command_line.overwrite = !command_line.restart;
                 numbers.push_back(number);
               });
  // The memory may be enough for each of them alone.
  perform_once(
      again, 1, [](unsigned int) {},
      [&](const unsigned int i, const std::string &failure)
      {
        ended(numbers[i],
              failure.empty() ? "" : "it was tried twice, the second time alone: " + failure);
      });
}

void RunPool::perform_once(const std::vector<PlannedRun> &plans,
                           const unsigned int n_at_a_time,
                           const Begins &begins,
                           const Ended &ended) const
{
  const FolderOfScreens screens;
  const double memory_limit = Continua::memory_limit().bytes;
  RunningRuns running; // gone before the screens
  unsigned int next = 0;
  double memory = 0.;
  bool is_interrupted = false;
  constexpr std::chrono::milliseconds longest_pause(20);
  std::chrono::milliseconds pause(1);
  while (!running.empty() || (next < plans.size() && !is_interrupted))
  {
    if (!is_interrupted && SignalWatch::pending() != 0)
    {
      is_interrupted = true;
      running.send(SignalWatch::pending());
      continue;
    }
    while (!is_interrupted && next < plans.size() && running.size() < n_at_a_time &&
           (running.empty() || memory + plans[next].memory <= memory_limit))
    {
      begins(next);
      std::string failure;
      try
      {
        running.push_back(
            {next, plans[next].memory, start(program, plans[next], screens.file(next))});
        memory += plans[next].memory;
      }
      catch (const std::exception &error)
      {
        failure = error.what();
      }
      if (!failure.empty())
        ended(next, failure);
      ++next;
    }
    bool has_any_ended = false;
    for (auto run = running.begin(); run != running.end();)
    {
      const std::optional<std::string> failure = end_of(*run, screens.file(run->number));
      if (!failure)
      {
        ++run;
        continue;
      }
      has_any_ended = true;
      const unsigned int number = run->number;
      memory -= run->memory;
      run = running.erase(run);
      if (!is_interrupted || failure->empty())
        ended(number, *failure);
    }
    pause = has_any_ended ? std::chrono::milliseconds(1) : std::min(2 * pause, longest_pause);
    if (!has_any_ended)
      std::this_thread::sleep_for(pause);
  }
  if (is_interrupted)
    throw Interrupted("interrupted by " + SignalWatch::name(SignalWatch::pending()) + " " +
                      among_runs);
}

unsigned int RunPool::n_cores()
{
  cpu_set_t cores;
  if (::sched_getaffinity(0, sizeof(cores), &cores) == 0)
    return static_cast<unsigned int>(std::max(CPU_COUNT(&cores), 1));
  return static_cast<unsigned int>(std::max(::sysconf(_SC_NPROCESSORS_ONLN), 1L));
}

bool is_run_of_a_pool(std::vector<char *> &arguments)
{
  if (arguments.size() < 2 ||
      std::string(arguments[1]).compare(0, mark_of_a_run.size(), mark_of_a_run) != 0)
    return false;
  const std::string parent = arguments[1] + mark_of_a_run.size();
  arguments.erase(arguments.begin() + 1);
#if defined(__linux__)
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
  // It may have ended before: then no signal comes.
  if (parent != std::to_string(::getppid()))
    ::raise(SIGTERM);
  return true;
}
} // namespace Continua
