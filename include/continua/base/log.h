#ifndef continua_base_log_h
#define continua_base_log_h

#include <continua/base/memory_use.h>
#include <continua/base/section_timer.h>

#include <mpi.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/**
 * What a run tells its user: plain lines on the screen of rank 0 and in log.txt, warnings (counted,
 * repeated in the summary), and on a terminal a progress line with time, step, rate and remaining
 * time. Off a terminal nothing is printed that depends on wall time, machine, absolute path or
 * number of ranks. Every method may be called on every rank; rank 0 writes.
 */
class Log
{
public:
  /// `on_screen` false: lines and warnings go to the file alone (one of several runs of an
  /// analysis); the progress line stays.
  /// `report_interval`: see progress() [s].
  explicit Log(MPI_Comm communicator, bool on_screen = true, double report_interval = 60.);
  ~Log();
  Log(const Log &) = delete;
  Log &operator=(const Log &) = delete;

  /// From now on the lines also go to this file (the earlier lines first); `append` after a
  /// restart. Throws RunError on rank 0 if it cannot be opened. Should the disk refuse later, the
  /// screen says so once and the run goes on.
  void open(const std::string &file, bool append);
  void line(const std::string &text);
  /// To log.txt only: what depends on the machine, wall time or ranks.
  void detail(const std::string &text);
  /// To log.txt and the error stream: what depends on the machine or the ranks, and what the user
  /// has to know while the run goes on.
  void note(const std::string &text);
  /// "warning: TEXT" once per text.
  void warning(const std::string &text);
  const std::vector<std::string> &warnings() const;
  /// Takes up the warnings of the part of the run before a restart, without telling them again.
  void resume_warnings(const std::vector<std::string> &earlier);

  /// Progress line on a terminal, at most five a second. Off a terminal one line a minute goes to
  /// the error stream, so that a short run prints none. Both have the remaining time. Times in s.
  void progress(double time, double end_time, unsigned int step);
  /// Clears the progress line.
  void end_progress();

  /// Wall time by section; use with SectionTimer::Scope. Each rank has its own and a scope costs no
  /// communication; what is printed is rank 0's.
  SectionTimer &timer();
  /// Wall time by section on this rank [s], and "total" since the log was made.
  std::map<std::string, double> wall_times() const;
  /// Writes the wall times to log.txt.
  void timing_summary();

  /// What holds the memory of this rank, by part.
  MemoryUse &memory_use();
  /// Writes to log.txt what holds the memory of rank 0, where the system says it.
  void memory_summary();

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation;
};
} // namespace Continua

#endif
