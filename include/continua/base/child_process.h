#ifndef continua_base_child_process_h
#define continua_base_child_process_h

#include <sys/types.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Continua
{
/**
 * A process that this one has started: a program, or a function in a copy of this process. It gets
 * the default reactions to signals, with none blocked. What still runs when the object dies is
 * killed.
 */
class ChildProcess
{
public:
  /// A program with its screen in a file.
  struct Program
  {
    std::string file;                     ///< its path
    std::vector<std::string> arguments;   ///< the name of the program first
    std::vector<std::string> environment; ///< "NAME=VALUE" each
    std::string screen;                   ///< file to which it appends what it prints
  };
  /// How a process ended, and the processor time that it and its own children took.
  struct End
  {
    int status = 0;          ///< as of waitpid()
    double user_time = 0.;   ///< [s]
    double system_time = 0.; ///< [s]
    /// The exit status, or the number of the signal that ended the process, negative.
    int exit_status() const;
  };

  /// Throws std::runtime_error if the program cannot be started.
  explicit ChildProcess(const Program &program);
  /// The copy ends by std::exit() with what `function` returns, in a session of its own. If this
  /// process is killed, it gets SIGTERM, which lets a run end with a checkpoint. Before MPI_Init
  /// only: MPI does not survive a copy. Throws std::runtime_error.
  explicit ChildProcess(const std::function<int()> &function);
  ~ChildProcess();
  ChildProcess(const ChildProcess &) = delete;
  ChildProcess &operator=(const ChildProcess &) = delete;

  /// Its end; nothing while it runs. Throws std::runtime_error if the process was lost.
  std::optional<End> end();
  /// Waits for the end of the process; kills it after `time_limit` [s] of the wall clock and throws
  /// std::runtime_error.
  End wait(double time_limit);
  /// Ends the process at once, and with it the processes of its session if it has one.
  void kill();
  pid_t number() const { return process; }

private:
  pid_t process = 0;
  bool has_session = false;
  std::optional<End> its_end;
};

/// Limits what this process may take, and lets it end with the process that started it.
/// Address space and files: `memory` [bytes]; no core file. The sanitizer of addresses reserves
/// terabytes for its own use: with it the address space has no limit.
void limit_this_process(std::size_t memory);

/// The environment without what a launcher of MPI gives to its processes.
std::vector<std::string> environment_without_launcher();
} // namespace Continua

#endif
