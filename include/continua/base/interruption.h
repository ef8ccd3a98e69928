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
 * While one lives, the signals SIGTERM, SIGINT, SIGHUP, SIGXCPU and SIGUSR1 do not end the program
 * but ask it to stop where it can go on later. SIGTERM or SIGINT again, two seconds or more after
 * the first signal, ends it at once: launchers and batch systems often send a signal twice at the
 * same time. The others never end it, since systems repeat them. All of this holds after the watch
 * too: the program then ends by itself at once. A program that was started with SIGHUP ignored
 * (nohup) goes on ignoring it. There is one watch at a time.
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

/**
 * While one lives (on all ranks), a signal is obeyed between the phases of the set-up of a run,
 * before there is anything to save.
 */
class InterruptibleSetUp
{
public:
  /// `remedy`: what the user can do after an interruption.
  explicit InterruptibleSetUp(const std::string &remedy);
  ~InterruptibleSetUp();
  InterruptibleSetUp(const InterruptibleSetUp &) = delete;
  InterruptibleSetUp &operator=(const InterruptibleSetUp &) = delete;

  /// Throws Interrupted on all ranks if a signal came on one of them: "interrupted by NAME in the
  /// set-up, after PHASE; REMEDY". Does nothing while none lives: the same phases come again where
  /// the mesh changes in mid-run. Collective.
  static void end_of_phase(MPI_Comm communicator, const std::string &phase);
};
} // namespace Continua

#endif
