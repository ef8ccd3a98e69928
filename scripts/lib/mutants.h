// scripts/measure/mutants copies this file into the tree in which all mutants are compiled. The
// environment variable CONTINUA_MUTANT=ID switches one mutant on. If
// CONTINUA_MUTANTS_REACHED=FOLDER is set, a process creates the file FOLDER/ID when it reaches the
// mutant ID for the first time.

#ifndef continua_mutants_h
#define continua_mutants_h

#include <fcntl.h>
#include <pthread.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>

namespace continua_mutants
{
constexpr int n_ids = 10000;

/// What this process has read of its environment.
struct State
{
  /// The array of variables that was read. A server that forks replaces the environment in the
  /// child, which changes the array.
  std::atomic<const void *> environment;
  std::atomic<int> active;
  std::atomic<bool> notes, handles_fork;
  std::atomic<bool> noted[n_ids];
};

/// All zeros, before any constructor runs.
inline State state;

// These functions are static: files that are compiled for other instruction sets have their own.

static void forget()
{
  state.environment = nullptr;
  for (std::atomic<bool> &noted : state.noted)
    noted = false;
}

__attribute__((noinline, cold)) static void read_environment()
{
  const char *const id = std::getenv("CONTINUA_MUTANT");
  state.active = id != nullptr ? std::atoi(id) : 0;
  state.notes = std::getenv("CONTINUA_MUTANTS_REACHED") != nullptr;
  if (!state.handles_fork.exchange(true))
    pthread_atfork(nullptr, nullptr, forget);
  state.environment = environ;
}

/// The kernel's own calls: a library that a test loads before all others must not see them.
__attribute__((noinline, cold)) static void note(const int id)
{
  const int error = errno;
  const char *const folder = std::getenv("CONTINUA_MUTANTS_REACHED");
  char path[4096];
  if (folder != nullptr && std::snprintf(path, sizeof path, "%s/%d", folder, id) < int(sizeof path))
  {
    const long file = syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    if (file >= 0)
      syscall(SYS_close, file);
  }
  errno = error;
  state.noted[id] = true;
}

/// Whether the mutant is switched on. Identifiers begin at 1.
__attribute__((always_inline)) static inline bool is_on(const int id)
{
  if (state.environment.load(std::memory_order_acquire) != environ)
    read_environment();
  if (state.notes.load(std::memory_order_relaxed) &&
      !state.noted[id].load(std::memory_order_relaxed))
    note(id);
  return state.active.load(std::memory_order_relaxed) == id;
}
} // namespace continua_mutants

#endif
