#ifndef continua_postprocess_field_writer_h
#define continua_postprocess_field_writer_h

#include <continua/postprocess/record.h>

#include <mpi.h>

#include <chrono>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
/**
 * The fields over the body for ParaView: fields.pvd, which lists the times, and the folder fields
 * with a solution-00000.vtu for each, or on several ranks a solution-00000.pvtu with the pieces
 * solution-00000.NUMBER.vtu. The list is written after the files that it names, whole each time.
 * Beside it is view-in-paraview.py, which opens it. Of more than a hundred states fields.pvd may
 * lack the last ones for a while, until the next checkpoint or the end of the run at the latest.
 * Methods are collective and throw RunError on all ranks when the disk refuses.
 */
template <int dim>
class FieldWriter : public Record<dim>
{
public:
  /// `folder`: the output folder, with a folder `fields` in it. `subdivisions` of each cell in each
  /// direction; `higher_order_cells`: they are drawn as one curved cell (Lagrange cells of VTK).
  /// `files_per_state`: into how many files the ranks write together; 0: each into one of its own.
  FieldWriter(MPI_Comm communicator,
              const std::string &folder,
              unsigned int subdivisions,
              bool higher_order_cells,
              unsigned int files_per_state = 0);
  ~FieldWriter() override;
  FieldWriter(const FieldWriter &) = delete;
  FieldWriter &operator=(const FieldWriter &) = delete;

  // As a record of a run: the states for which its schedule asks.
  void open(ContinuumSolver<dim> &solver, const std::string &folder, bool is_due) override;
  void resume(ContinuumSolver<dim> &solver, const std::string &folder, double time) override;
  void record(const RecordedStep<dim> &step) override;
  void finish(const RecordedEnd<dim> &end) override;
  /// Each rank flushes the files that it has written since the last call.
  void flush_to_disk() override;
  /// fields.pvd up to its last entry.
  std::optional<WrittenTable> table() const override;

  /// Continues after a restart at `restart_time` [s]: entries up to it are kept, files of later
  /// states are removed.
  void resume(double restart_time);
  /// Writes the present state under `time` [s]; a second state at the same time replaces the first.
  void write(ContinuumSolver<dim> &solver, double time);
  /// Adds the fields' units to the summary; nothing if no field was written.
  void finish(Summary &summary) const;

private:
  using Clock = std::chrono::steady_clock;

  /// Writes the list as it is to be, as one file that is whole at all times.
  void write_list();
  /// Has states listed that are not.
  void complete_list();
  /// Writes this rank's part of the file `base` with the number of its group; empty if all is well.
  std::string
  write_together(dealii::DataOut<dim> &data_out, const std::string &file, unsigned int group) const;
  /// Removes the files of the states that are not in the list.
  void remove_later_states() const;

  MPI_Comm communicator;
  std::string folder;
  unsigned int subdivisions;
  bool higher_order_cells;
  unsigned int files_per_state;
  std::vector<std::pair<double, std::string>> entries; ///< time [s] and file, from the folder
  // Of fields.pvd, on the writing rank:
  bool list_is_behind = false; ///< it lacks the last states
  Clock::time_point list_is_written_at;
  Clock::duration duration_of_list = Clock::duration::zero();
  std::map<std::string, std::string> units; ///< of the fields
  bool has_view = false;                    ///< view-in-paraview.py is written
  std::set<std::string> not_flushed;        ///< files of this rank
};
} // namespace Continua

#endif
