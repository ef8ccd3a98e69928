// A library that takes SIGTERM for itself leaves no trace.

#include <continua/base/kept_signal_action.h>

#include "../unit_test.h"

#include <csignal>

namespace test_of_kept_signal_action
{
using namespace Continua;

namespace
{
volatile std::sig_atomic_t n_signals = 0, n_of_library = 0;

void count(int)
{
  n_signals = n_signals + 1;
}

void count_of_library(int)
{
  n_of_library = n_of_library + 1;
}

/// As METIS does: its own handler, then the one before by signal() of System V.
void act_as_library(const bool is_told)
{
  const sighandler_t before = sysv_signal(SIGTERM, count_of_library);
  if (is_told)
    raise(SIGTERM);
  sysv_signal(SIGTERM, before);
}

int flags()
{
  struct sigaction action = {};
  sigaction(SIGTERM, nullptr, &action);
  return action.sa_flags & ~0x04000000; // SA_RESTORER, which the library of C adds
}
} // namespace

UNIT_TEST(kept_signal_action)
{
  (void)argc;
  (void)argv;
  struct sigaction action = {};
  action.sa_handler = count;
  action.sa_flags = SA_RESTART;
  sigaction(SIGTERM, &action, nullptr);
  act_as_library(false);
  check::is_true("without it the handler works once", (flags() & SA_RESETHAND) != 0);

  sigaction(SIGTERM, &action, nullptr);
  {
    const KeptSignalAction kept;
    act_as_library(true);
    {
      const KeptSignalAction inner;
    }
    check::is_true("the signal waits", n_signals == 0 && n_of_library == 0);
  }
  check::is_true("it comes at the end, to the handler before", n_signals == 1 && n_of_library == 0);
  check::is_true("which has its flags", flags() == SA_RESTART);
  raise(SIGTERM);
  raise(SIGTERM);
  check::is_true("and works again and again", n_signals == 3);
}
} // namespace test_of_kept_signal_action
