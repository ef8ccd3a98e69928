#ifndef continua_postprocess_record_h
#define continua_postprocess_record_h

#include <continua/base/archive.h>
#include <continua/base/log.h>
#include <continua/base/summary.h>
#include <continua/base/written_table.h>
#include <continua/continuum/continuum_solver.h>
#include <continua/time_integration/step.h>
#include <continua/time_integration/time_control.h>

#include <optional>
#include <string>

namespace Continua
{
/// A part of a step that stands. Most steps have one part; those that start a scheme may have two.
template <int dim>
struct RecordedStep
{
  ContinuumSolver<dim> &solver; ///< with the state at the end of the part
  const Step &part;
  double time;    ///< of the end of the whole step [s]
  double size;    ///< of the whole step [s]
  bool ends_step; ///< whether the step ends with this part
  bool is_due;    ///< whether it ends with this part, and the record's schedule asks for its state
  Log &log;
};

/// A change of the mesh, after which the state has been carried over.
template <int dim>
struct MeshChange
{
  ContinuumSolver<dim> &solver;
  double time;          ///< [s]
  const Energy &before; ///< the energy on the mesh before
  const Energy &after;  ///< and on the present mesh
};

/// The end of a run.
template <int dim>
struct RecordedEnd
{
  ContinuumSolver<dim> &solver;
  const TimeControl &time_control;
  Summary &summary;
  Log &log;
};

/**
 * What is kept of a transient run on its way: a table, pictures, or numbers for the summary. The
 * order of calls: open() or else load() and resume(), then for each step attempt() once or more,
 * take() and record() for each of its parts, change_mesh() where the mesh changes after a step, and
 * finish(). All are collective, and throw RunError on all ranks when the disk refuses unless said
 * otherwise. A record overrides what it needs.
 */
template <int dim>
class Record
{
public:
  virtual ~Record() = default;

  /// Before the first step: `solver` has the initial state. `folder`: of the output. `is_due`:
  /// whether the record's schedule asks for this state.
  virtual void
  open(ContinuumSolver<dim> & /*solver*/, const std::string & /*folder*/, bool /*is_due*/)
  {
  }
  /// Instead, after load() in a run that goes on: what was written after `time` [s] goes.
  virtual void
  resume(ContinuumSolver<dim> & /*solver*/, const std::string & /*folder*/, double /*time*/)
  {
  }

  /// Every attempt to make a step or a part of it, whether it stands or is undone.
  virtual void attempt(const StepReport & /*report*/) {}
  /// A part that stands and ends at `time` [s], before it is known whether the run diverges.
  virtual void take(const StepReport & /*report*/, double /*time*/, Log & /*log*/) {}
  /// A part that stands. RunError on rank 0.
  virtual void record(const RecordedStep<dim> & /*step*/) {}
  virtual void change_mesh(const MeshChange<dim> & /*change*/) {}
  /// Closes the files and adds to the summary.
  virtual void finish(const RecordedEnd<dim> & /*end*/) {}

  /// What it remembers from step to step, for a restart.
  virtual void save(ArchiveWriter & /*archive*/) const {}
  virtual void load(const ArchiveReader & /*archive*/) {}
  /// Writes what is buffered of its files, and waits until the disk has it.
  virtual void flush_to_disk() {}
  /// What is written of the table that it continues after a restart; none on a rank that does not
  /// write it, and where it has not begun.
  virtual std::optional<WrittenTable> table() const { return std::nullopt; }
};
} // namespace Continua

#endif
