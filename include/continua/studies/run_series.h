#ifndef continua_studies_run_series_h
#define continua_studies_run_series_h

#include <continua/analysis/analysis_table.h>
#include <continua/base/log.h>
#include <continua/base/output_directory.h>
#include <continua/base/summary.h>
#include <continua/studies/planned_run.h>

#include <mpi.h>

#include <functional>
#include <string>
#include <vector>

namespace Continua
{
/// What one run states in its summary.
struct RunResult
{
  std::string name;       ///< of its folder: "taylor-hood-0"
  std::string failure;    ///< why it failed; empty if it finished
  double n_cells = 0.;    ///< [1]
  double n_dofs = 0.;     ///< [1] of all fields
  double cell_size = 0.;  ///< [m], the dim-th root of volume over cells
  double wall_time = 0.;  ///< [s]
  double n_steps = 0.;    ///< [1]
  double iterations = 0.; ///< [1] of linear solvers or correction loops, over the run; 0: none
  std::vector<Quantity> quantities;
};

/// The largest Mesh/Refinements.
constexpr unsigned int most_refinements = 12;

/**
 * Several runs of one parameter file, each in a folder of its own in the output folder: one after
 * the other on all ranks, or on one rank side by side (RunPool). A run that fails is reported with
 * its reason; the others go on.
 */
class RunSeries
{
public:
  /// `analyses`: those that there are. `input_files`: of the parameter file, which no output folder
  /// may hold. `volume`: of the mesh [m^dim], for the sizes of cells; 0: there is none.
  /// `n_parallel`: so many runs at a time; on several ranks one.
  RunSeries(const AnalysisTable &analyses,
            MPI_Comm communicator,
            unsigned int dimension,
            const CommandLine &command_line,
            const std::vector<std::string> &input_files,
            double volume,
            unsigned int n_parallel = 1);

  /// `number`: of the run among the plans.
  using Finished = std::function<void(const RunResult &run, unsigned int number)>;

  /**
   * Performs the runs in their order; collective. Returns what each run has stated, the same on all
   * ranks. With --restart the runs that the folder holds are taken as they are, if they were
   * finished by this program with the same input and as many ranks: what they stated stands in
   * their folder. One that was begun so goes on from its checkpoint, if it has one. `finished` is
   * called for each that did not fail, with its number, in the order of the plans. May be called
   * again with further plans for the same folder.
   */
  std::vector<RunResult> perform(const std::vector<PlannedRun> &plans,
                                 const OutputDirectory &directory,
                                 Log &log,
                                 const Finished &finished);

private:
  /// What is to be done with a run.
  enum class State
  {
    fresh,   ///< begins
    begun,   ///< goes on from its checkpoint
    finished ///< was finished before
  };

  const AnalysisTable &analyses;
  MPI_Comm communicator;
  unsigned int dimension;
  CommandLine command_line;
  std::vector<std::string> input_files;
  double volume;
  unsigned int n_parallel;
  /// What tells this program from others, as it was started: its file may be replaced meanwhile.
  std::string program;
  /// The checkpoint of a series: a line for each run that is finished, or was begun.
  std::string finished_runs, begun_runs;

  /// What identifies the input, the program and the ranks of a run.
  std::string identity(const PlannedRun &plan) const;
  State state_of(const PlannedRun &plan) const;
  /// Empties the folders of the runs that begin anew. Throws InputError for one that may not be
  /// used.
  void prepare_folders(const std::vector<PlannedRun> &plans,
                       const std::vector<State> &states,
                       const OutputDirectory &directory) const;
  /// Notes, in the folder of the series, that the run was begun, or is finished.
  void note(const PlannedRun &plan, const OutputDirectory &directory, State state);
  void write_records(const OutputDirectory &directory) const;
  /// The run with what it is to do in its folder.
  static PlannedRun in_state(PlannedRun plan, State state);
  /// Performs the run, fills its summary and returns why it failed; empty if it did not.
  std::string perform(const PlannedRun &plan, Summary &summary) const;
  /// The summary that stands in the folder of a run, the same on all ranks. Where there is none,
  /// or none that can be read, `failure` says so unless it says already why the run failed.
  Summary summary_in_folder(const PlannedRun &plan, std::string &failure) const;
  bool has_summary(const PlannedRun &plan) const;
  /// What rank 0 finds in the summary of a run, the same on all ranks.
  RunResult result(const PlannedRun &plan, const Summary &summary) const;
};

/// Sets the status of a series in its summary, with the reasons of those runs that failed, if any:
/// returns their names, for a RunError.
std::string set_status(Summary &summary, const std::vector<RunResult> &runs);
} // namespace Continua

#endif
