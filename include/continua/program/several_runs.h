#ifndef continua_program_several_runs_h
#define continua_program_several_runs_h

#include <continua/base/command_line.h>

#include <functional>

namespace Continua
{
/**
 * Performs several parameter files, each in a copy of this process, which has loaded its libraries:
 * a further run starts in some hundredths of a second, where a program takes half a second. A run
 * that fails or is refused leaves the others as they are. A signal goes to the runs that are at
 * work, and no further one begins.
 */
class SeveralRuns
{
public:
  /// What performs a command line, as main(): MPI is initialised in it, never before it.
  using Main = std::function<int(int argc, char **argv)>;

  /// The command line, with its further files, must outlive it. Throws InputError if one of the
  /// files is not there.
  SeveralRuns(const CommandLine &command_line, Main main);

  /// Runs all of them, prints which run failed, and returns the exit status: 0 if all are done, 1
  /// if a run failed or was interrupted, else 2 if an input was refused.
  int perform() const;

private:
  const CommandLine &command_line;
  const Main main;
};
} // namespace Continua

#endif
