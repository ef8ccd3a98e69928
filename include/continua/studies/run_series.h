#ifndef continua_studies_run_series_h
#define continua_studies_run_series_h

#include <continua/analysis/analysis_table.h>
#include <continua/base/command_line.h>
#include <continua/base/log.h>
#include <continua/base/output_directory.h>
#include <continua/base/summary.h>

#include <mpi.h>

#include <functional>
#include <string>
#include <vector>

namespace Continua
{
/// One of several runs of a file: with other entries, in a folder of its own.
struct PlannedRun
{
  std::string name;         ///< of its folder
  CommandLine command_line; ///< with its entries set
  std::string identity;     ///< of the case, and of what else its results depend on
};

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

/// "taylor-hood" from "Taylor hood".
std::string folder_name(const std::string &text);

/// Sets an entry, "Section/Key", over the file and over what the command line says of it.
void set_entry(CommandLine &command_line, const std::string &path, const std::string &value);

/**
 * Several runs of one parameter file, one after the other, each in a folder of its own in the
 * output folder. A run that fails is reported with its reason; the others go on.
 */
class RunSeries
{
public:
  /// `analyses`: those that there are. `input_files`: of the parameter file, which no output folder
  /// may hold. `volume`: of the mesh [m^dim].
  RunSeries(const AnalysisTable &analyses,
            MPI_Comm communicator,
            unsigned int dimension,
            const CommandLine &command_line,
            const std::vector<std::string> &input_files,
            double volume);

  /**
   * Performs the runs in their order; collective. Returns what each run has stated, the same on all
   * ranks. With --restart the runs that the folder holds are taken as they are, if they were
   * finished by this program with the same input and as many ranks: what they stated stands in
   * their folder. `finished` is called for each that did not fail, with its number.
   */
  std::vector<RunResult>
  perform(const std::vector<PlannedRun> &plans,
          const OutputDirectory &directory,
          Log &log,
          const std::function<void(const RunResult &, unsigned int)> &finished) const;

private:
  const AnalysisTable &analyses;
  MPI_Comm communicator;
  unsigned int dimension;
  CommandLine command_line;
  std::vector<std::string> input_files;
  double volume;

  /// What identifies the input, the program and the ranks of a run.
  std::string identity(const PlannedRun &plan) const;
  /// Performs the run, fills its summary and returns why it failed; empty if it did not.
  std::string
  perform(const PlannedRun &plan, const OutputDirectory &directory, Summary &summary) const;
  /// The summary that stands in the folder of a run, the same on all ranks.
  Summary summary_in_folder(const PlannedRun &plan) const;
  /// What rank 0 finds in the summary of a run, the same on all ranks.
  RunResult result(const PlannedRun &plan, const Summary &summary) const;
};

/// Sets the status of a series in its summary, with the reasons of those runs that failed, if any:
/// returns their names, for a RunError.
std::string set_status(Summary &summary, const std::vector<RunResult> &runs);
} // namespace Continua

#endif
