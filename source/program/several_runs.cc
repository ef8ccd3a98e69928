#include <continua/base/child_process.h>
#include <continua/base/input_error.h>
#include <continua/base/input_file.h>
#include <continua/base/rank_agreement.h>
#include <continua/program/several_runs.h>

#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <list>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
namespace
{
/// Those that end a run after its present step; they are passed on.
constexpr std::array<int, 5> signals_of_ends = {{SIGTERM, SIGINT, SIGHUP, SIGXCPU, SIGUSR1}};

/// A file without a name, for what a run prints while others print, too.
using Screen = std::unique_ptr<std::FILE, int (*)(std::FILE *)>;

struct RunOfAFile
{
  std::string file;
  std::vector<std::string> arguments;
  Screen screen = {nullptr, &std::fclose};
  std::unique_ptr<ChildProcess> process;
  int status = 0;
};

/// Blocks the signals that are waited for.
sigset_t watch_signals()
{
  sigset_t watched;
  ::sigemptyset(&watched);
  ::sigaddset(&watched, SIGCHLD);
  for (const int signal : signals_of_ends)
    ::sigaddset(&watched, signal);
  sigset_t blocked = watched;
  // Whoever reads the screen may go: the runs go on.
  ::sigaddset(&blocked, SIGPIPE);
  ::sigprocmask(SIG_BLOCK, &blocked, nullptr);
  return watched;
}

/// In the copy: becomes the program of one run.
int become(std::vector<std::string> &arguments,
           std::FILE *const screen,
           const SeveralRuns::Main &main)
{
  if (screen != nullptr &&
      (::dup2(::fileno(screen), STDOUT_FILENO) < 0 || ::dup2(::fileno(screen), STDERR_FILENO) < 0))
    throw std::runtime_error(std::string("the screen of a run cannot be kept: ") +
                             std::strerror(errno));
  std::vector<char *> pointers;
  pointers.reserve(arguments.size() + 1);
  for (std::string &argument : arguments)
    pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  return main(static_cast<int>(arguments.size()), pointers.data());
}

void start(RunOfAFile &run, const bool others_print, const SeveralRuns::Main &main)
{
  if (others_print)
  {
    run.screen.reset(std::tmpfile());
    if (run.screen == nullptr)
      throw RunError(std::string("no temporary file for the screen of a run: ") +
                     std::strerror(errno));
  }
  else
    std::cout << "== " << printable(run.file) << std::endl;
  run.process = std::make_unique<ChildProcess>(
      [&run, &main] { return become(run.arguments, run.screen.get(), main); });
}

/// What it has printed, once it has ended.
void print_screen(RunOfAFile &run)
{
  if (run.screen == nullptr)
    return;
  std::cout << "== " << printable(run.file) << "\n";
  std::rewind(run.screen.get());
  std::array<char, 65536> part;
  while (const std::size_t n = std::fread(part.data(), 1, part.size(), run.screen.get()))
    std::cout.write(part.data(), static_cast<std::streamsize>(n));
  std::cout.flush();
  run.screen.reset();
}

std::string text_of_status(const int status)
{
  if (status == exit_status_of_wrong_input)
    return "refused";
  if (status < 0)
    return "ended by signal " + std::to_string(-status);
  return "not finished";
}
} // namespace

SeveralRuns::SeveralRuns(const CommandLine &command_line, Main main)
    : command_line(command_line), main(std::move(main))
{
  std::vector<std::string> files = command_line.further_files;
  files.insert(files.begin(), command_line.parameter_file);
  for (const std::string &file : files)
    if (!std::filesystem::exists(file))
      throw InputError({"command line", 0}, file, "there is no such parameter file",
                       "Each argument that belongs to no option is a parameter file; the folder of "
                       "the results is --output DIR");
}

int SeveralRuns::perform() const
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  std::vector<std::string> files = command_line.further_files;
  files.insert(files.begin(), command_line.parameter_file);
  const sigset_t watched = watch_signals();
  std::list<RunOfAFile> runs;
  std::size_t n_started = 0, n_at_work = 0;
  bool is_interrupted = false;
  while (n_at_work > 0 || (n_started < files.size() && !is_interrupted))
  {
    while (n_at_work < command_line.n_jobs && n_started < files.size() && !is_interrupted)
    {
      RunOfAFile run;
      run.file = files[n_started++];
      run.arguments = command_line.arguments_with_file(run.file);
      runs.push_back(std::move(run));
      start(runs.back(), command_line.n_jobs > 1, main);
      ++n_at_work;
    }
    const timespec longest_wait = {1, 0};
    siginfo_t signal = {};
    const int number = ::sigtimedwait(&watched, &signal, &longest_wait);
    if (number > 0 && number != SIGCHLD)
    {
      is_interrupted = true;
      for (const RunOfAFile &run : runs)
        if (run.process != nullptr)
          ::kill(run.process->number(), number);
    }
    for (RunOfAFile &run : runs)
    {
      const auto end = run.process == nullptr ? std::nullopt : run.process->end();
      if (!end)
        continue;
      run.status = end->exit_status();
      run.process.reset();
      print_screen(run);
      --n_at_work;
    }
  }

  std::ostringstream text;
  int status = 0;
  std::size_t n_done = 0;
  for (const RunOfAFile &run : runs)
  {
    if (run.status == 0)
    {
      ++n_done;
      continue;
    }
    text << printable(run.file) << ": " << text_of_status(run.status) << "\n";
    if (run.status != exit_status_of_wrong_input)
      status = exit_status_of_failure;
    else if (status == 0)
      status = exit_status_of_wrong_input;
  }
  for (std::size_t i = n_started; i < files.size(); ++i)
  {
    text << printable(files[i]) << ": not begun\n";
    status = exit_status_of_failure;
  }
  std::cout << "== " << n_done << " of " << files.size() << " runs done in "
            << std::chrono::duration<double>(Clock::now() - begin).count() << " s" << std::endl;
  std::cerr << text.str() << std::flush;
  return status;
}
} // namespace Continua
