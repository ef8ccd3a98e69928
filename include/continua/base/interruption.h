#ifndef continua_base_interruption_h
#define continua_base_interruption_h

#include <continua/base/input_error.h>

#include <mpi.h>

#include <string>

namespace Continua
{
/// The run was asked to stop and did so in good order, on all ranks: exit status 1.
class Interrupted : public RunError
{
public:
  using RunError::RunError;
};

/**
 * While one lives, the signals SIGTERM, SIGINT and SIGUSR1 do not end the program but ask it to
 * stop where it can go on later. SIGTERM or SIGINT again, a second or more after the first one,
 * ends it at once: launchers and batch systems often send a signal twice at the same time. There is
 * one at a time.
 */
class SignalWatch
{
public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch &) = delete;
  SignalWatch &operator=(const SignalWatch &) = delete;

  /// The signal that came on this rank; 0: none.
  static int pending();
  /// Throws Interrupted on all ranks if a signal came on one of them: "interrupted by NAME WHERE".
  /// Collective.
  static void stop_if_asked(MPI_Comm communicator, const std::string &where);
  /// "SIGTERM".
  static std::string name(int signal);
};
} // namespace Continua

#endif
