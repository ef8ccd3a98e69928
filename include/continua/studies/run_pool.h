#ifndef continua_studies_run_pool_h
#define continua_studies_run_pool_h

#include <continua/studies/planned_run.h>

#include <functional>
#include <string>
#include <vector>

namespace Continua
{
/**
 * Performs runs side by side: each is a process of this program on one rank, started with the
 * parameter file and the entries of the run, since MPI does not survive a copy of this process.
 * The next run begins when one has ended, and only if the runs at work leave it the memory that it
 * may need by estimate; a run begins in any case when no other is at work.
 *
 * A run that a signal ends, as the system does where memory is at its end, or that fails for want
 * of memory says nothing of its input: it is performed again, alone, when all others have ended,
 * from its checkpoint if it has one.
 *
 * A signal that SignalWatch has seen goes to the runs, which end with a checkpoint where their
 * analysis has one. If this process is killed, they get SIGTERM.
 */
class RunPool
{
public:
  /// `n_parallel`: so many at a time, at least one. `program`: its path; another one for tests.
  explicit RunPool(unsigned int n_parallel, std::string program = "/proc/self/exe");

  /// `number`: of the run among the plans.
  using Begins = std::function<void(unsigned int number)>;
  /// `failure`: why the run failed; empty if it finished, its results then stand in its folder.
  using Ended = std::function<void(unsigned int number, const std::string &failure)>;
  /// `failure`: why the run will be performed again.
  using Again = std::function<void(unsigned int number, const std::string &failure)>;

  /**
   * Performs the runs, begun in their order. `begins` is called before each, `ended` after each in
   * the order in which they end; of a run that is performed again once, after the second time, and
   * `again_of` after the first. A run that cannot be started has failed. What `begins`, `ended` or
   * `again_of` throws goes on when the runs at work have ended: they get SIGTERM, and are killed
   * after 30 s. Throws Interrupted when all have
   * ended after a signal; a run that the signal ended is not reported. On one rank alone.
   */
  void perform(
      const std::vector<PlannedRun> &plans,
      const Begins &begins,
      const Ended &ended,
      const Again &again_of = [](unsigned int, const std::string &) {}) const;

  /// The cores that this process may use, at least one.
  static unsigned int n_cores();

private:
  unsigned int n_parallel;
  std::string program;

  /// The same, each run once.
  void perform_once(const std::vector<PlannedRun> &plans,
                    unsigned int n_at_a_time,
                    const Begins &begins,
                    const Ended &ended) const;
};

/// Whether a run failed since a signal ended it, or for want of memory, by what RunPool says of it.
bool says_nothing_of_input(const std::string &failure);

/// Where a study was interrupted, and what the user can do.
extern const std::string among_runs;

/// Whether this process is a run that a pool has started: it then ends with the process that
/// started it, by SIGTERM, also if that is gone already. Takes the mark of such a run out of the
/// arguments.
bool is_run_of_a_pool(std::vector<char *> &arguments);
} // namespace Continua

#endif
