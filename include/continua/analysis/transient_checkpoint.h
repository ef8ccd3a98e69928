#ifndef continua_analysis_transient_checkpoint_h
#define continua_analysis_transient_checkpoint_h

#include <continua/analysis/checkpoint.h>
#include <continua/analysis/transient_progress.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace Continua
{
/// Writes the checkpoints of a run in time, and goes on from one.
template <int dim>
class TransientCheckpoint
{
public:
  /// Must outlive it.
  explicit TransientCheckpoint(TransientProgress<dim> &so_far);

  /// Sets the body, the tables and the records up as they were when the last checkpoint was
  /// written.
  void restart();
  /// Writes a checkpoint if one is due; also ends the run if a signal asks for it.
  void save_or_stop();
  void write();

private:
  TransientProgress<dim> &so_far;
  Run<dim> &run;
  Checkpoint checkpoint;
  Schedule checkpoint_schedule;
  unsigned long n_restarts = 0;
  Checksum of_log;               ///< of log.txt as it was at the last checkpoint
  double earlier_wall_time = 0.; ///< [s] of the run before the restart
  std::chrono::steady_clock::time_point last_checkpoint = std::chrono::steady_clock::now();

  /// Calls a function that reads the checkpoint, with a word in its errors of where they come from.
  void read(const std::function<void()> &reader) const;
  void flush_log_to_disk();
  /// What a restart continues, on rank 0.
  std::vector<WrittenTable> written_tables() const;
};
} // namespace Continua

#endif
