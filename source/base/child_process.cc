#include <continua/base/child_process.h>
#include <continua/base/message_passing.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
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
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace Continua
{
namespace
{
std::vector<char *> pointers_to(const std::vector<std::string> &texts)
{
  std::vector<char *> result;
  result.reserve(texts.size() + 1);
  for (const std::string &text : texts)
    result.push_back(const_cast<char *>(text.c_str()));
  result.push_back(nullptr);
  return result;
}

[[noreturn]] void fail_to_start(const int error)
{
  throw std::runtime_error(std::string("its process cannot be started: ") + std::strerror(error));
}

double seconds(const timeval &time)
{
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// The reactions to signals that a program begins with.
void forget_signals()
{
  for (const int signal : {SIGCHLD, SIGTERM, SIGINT, SIGHUP, SIGPIPE, SIGXCPU, SIGXFSZ, SIGUSR1})
    std::signal(signal, SIG_DFL);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

/// An exception must not unwind into what the parent was doing.
int status_of(const std::function<int()> &function)
{
  try
  {
    return function();
  }
  catch (const std::exception &error)
  {
    std::cerr << "error: " << error.what() << std::endl;
  }
  catch (...)
  {
    std::cerr << "error: an error without a text" << std::endl;
  }
  return 1;
}

// GCC says it by a macro, clang by a feature.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool has_address_sanitizer = true;
#elif defined(__has_feature)
constexpr bool has_address_sanitizer = __has_feature(address_sanitizer);
#else
constexpr bool has_address_sanitizer = false;
#endif
} // namespace

int ChildProcess::End::exit_status() const
{
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

ChildProcess::ChildProcess(const Program &program)
{
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  sigset_t no_signals;
  ::sigemptyset(&no_signals);
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&files, 1, program.screen.c_str(),
                                     O_WRONLY | O_CREAT | O_APPEND, 0600);
  ::posix_spawn_file_actions_adddup2(&files, 1, 2);
  ::posix_spawnattr_init(&attributes);
  ::posix_spawnattr_setsigmask(&attributes, &no_signals);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  const std::vector<char *> arguments = pointers_to(program.arguments),
                            environment = pointers_to(program.environment);
  const int error = ::posix_spawn(&process, program.file.c_str(), &files, &attributes,
                                  arguments.data(), environment.data());
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&files);
  if (error != 0)
    fail_to_start(error);
}

ChildProcess::ChildProcess(const std::function<int()> &function) : has_session(true)
{
  // What is kept for the screen would be printed twice.
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
  process = ::fork();
  if (process < 0)
    fail_to_start(errno);
  if (process > 0)
    return;
  ::setsid();
  forget_signals();
#if defined(__linux__)
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
  std::exit(status_of(function));
}

ChildProcess::~ChildProcess()
{
  if (its_end || process <= 0)
    return;
  kill();
  ::waitpid(process, nullptr, 0);
}

std::optional<ChildProcess::End> ChildProcess::end()
{
  if (its_end)
    return its_end;
  int status = 0;
  rusage usage;
  const pid_t ended = ::wait4(process, &status, WNOHANG, &usage);
  if (ended < 0 && errno != EINTR)
    throw std::runtime_error(std::string("its process was lost: ") + std::strerror(errno));
  if (ended == process)
    its_end = {status, seconds(usage.ru_utime), seconds(usage.ru_stime)};
  return its_end;
}

ChildProcess::End ChildProcess::wait(const double time_limit)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  std::chrono::milliseconds pause(1);
  while (true)
  {
    if (const std::optional<End> its = end())
      return *its;
    if (std::chrono::duration<double>(Clock::now() - start).count() > time_limit)
    {
      kill();
      std::ostringstream text;
      text << "it did not end within " << time_limit << " s";
      throw std::runtime_error(text.str());
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::milliseconds(50));
  }
}

void ChildProcess::kill()
{
  if (its_end)
    return;
  // The process may not have made its session yet.
  if (has_session)
    ::kill(-process, SIGKILL);
  ::kill(process, SIGKILL);
}

void limit_this_process(const std::size_t memory)
{
  const rlimit limit = {memory, memory};
  const rlimit nothing = {0, 0};
  if (!has_address_sanitizer)
    ::setrlimit(RLIMIT_AS, &limit);
  ::setrlimit(RLIMIT_FSIZE, &limit);
  ::setrlimit(RLIMIT_CORE, &nothing);
#if defined(__linux__)
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
}

std::vector<std::string> environment_without_launcher()
{
  std::vector<std::string> kept;
  for (char **entry = environ; *entry != nullptr; ++entry)
    if (!is_of_launcher(*entry))
      kept.emplace_back(*entry);
  return kept;
}
} // namespace Continua
