#include <continua/base/interruption.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <array>
#include <csignal>
#include <ctime>
#include <memory>

namespace Continua
{
namespace
{
struct WatchedSignal
{
  int number;
  const char *name;
  /// Whether a second one ends the program at once.
  bool insists;
};

constexpr std::array<WatchedSignal, 5> signals = {{{SIGTERM, "SIGTERM", true},
                                                   {SIGINT, "SIGINT", true},
                                                   {SIGHUP, "SIGHUP", false},
                                                   {SIGXCPU, "SIGXCPU", false},
                                                   {SIGUSR1, "SIGUSR1", false}}};

volatile std::sig_atomic_t first_signal = 0;
volatile std::time_t first_time = 0;
bool is_watching = false;
/// Of the set-up that may be interrupted now; null: none.
std::unique_ptr<std::string> remedy_of_set_up;

/// Seconds of a clock that a handler may read.
std::time_t now()
{
  timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec;
}

void handle(const int signal)
{
  if (first_signal == 0)
  {
    first_time = now();
    first_signal = signal;
  }
  else if ((signal == SIGTERM || signal == SIGINT) && now() > first_time + 1)
  {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

/// Blocks or unblocks the signals that never end the program.
void mask_others(const int how)
{
  sigset_t others;
  sigemptyset(&others);
  for (const WatchedSignal &signal : signals)
    if (!signal.insists)
      sigaddset(&others, signal.number);
  pthread_sigmask(how, &others, nullptr);
}
} // namespace

SignalWatch::SignalWatch()
{
  AssertThrow(!is_watching, dealii::ExcMessage("Signals are watched already."));
  is_watching = true;
  first_signal = 0;
  struct sigaction action = {};
  action.sa_handler = handle;
  // Files that are being written go on.
  action.sa_flags = SA_RESTART;
  for (const WatchedSignal &signal : signals)
  {
    struct sigaction earlier = {};
    sigaction(signal.number, &action, &earlier);
    if (signal.number == SIGHUP && earlier.sa_handler == SIG_IGN)
      sigaction(SIGHUP, &earlier, nullptr);
  }
  mask_others(SIG_UNBLOCK);
}

SignalWatch::~SignalWatch()
{
  // The handlers stay: the program is at its end, or watches again. What comes now must not end it
  // by a signal when all is written, nor while it puts things in order.
  is_watching = false;
  // Libraries that end with MPI put back the action that they found, which would end the program.
  mask_others(SIG_BLOCK);
}

int SignalWatch::pending()
{
  return first_signal;
}

void SignalWatch::stop_if_asked(const MPI_Comm communicator, const std::string &where)
{
  const int signal = dealii::Utilities::MPI::max(pending(), communicator);
  if (signal != 0)
    throw Interrupted("interrupted by " + name(signal) + " " + where);
}

std::string SignalWatch::name(const int signal)
{
  for (const WatchedSignal &watched : signals)
    if (watched.number == signal)
      return watched.name;
  return "signal " + std::to_string(signal);
}

InterruptibleSetUp::InterruptibleSetUp(const std::string &remedy)
{
  remedy_of_set_up = std::make_unique<std::string>(remedy);
}

InterruptibleSetUp::~InterruptibleSetUp()
{
  remedy_of_set_up.reset();
}

void InterruptibleSetUp::end_of_phase(const MPI_Comm communicator, const std::string &phase)
{
  if (remedy_of_set_up)
    SignalWatch::stop_if_asked(communicator,
                               "in the set-up, after " + phase + "; " + *remedy_of_set_up);
}
} // namespace Continua
