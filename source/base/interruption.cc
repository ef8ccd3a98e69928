#include <continua/base/interruption.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <array>
#include <csignal>
#include <ctime>

namespace Continua
{
namespace
{
constexpr std::array<int, 3> signals = {{SIGTERM, SIGINT, SIGUSR1}};

volatile std::sig_atomic_t first_signal = 0;
volatile std::time_t first_time = 0;
std::array<struct sigaction, signals.size()> earlier_actions;
bool is_watching = false;

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
  else if (signal != SIGUSR1 && now() > first_time + 1)
  {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
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
  for (unsigned int i = 0; i < signals.size(); ++i)
    sigaction(signals[i], &action, &earlier_actions[i]);
}

SignalWatch::~SignalWatch()
{
  for (unsigned int i = 0; i < signals.size(); ++i)
    sigaction(signals[i], &earlier_actions[i], nullptr);
  is_watching = false;
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
  return signal == SIGTERM ? "SIGTERM" : signal == SIGINT ? "SIGINT" : "SIGUSR1";
}
} // namespace Continua
