#ifndef continua_analysis_analysis_h
#define continua_analysis_analysis_h

#include <continua/base/command_line.h>
#include <continua/base/log.h>
#include <continua/base/output_directory.h>
#include <continua/base/parameter_file.h>
#include <continua/base/quantity_names.h>
#include <continua/base/summary.h>
#include <continua/case/case.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace Continua
{
class AnalysisTable;

/// What an analysis is made of. All but the command line and `general` must outlive it.
struct AnalysisInput
{
  ParameterFile &file;
  const GeneralParameters &general; ///< of the file, which are read already
  const CommandLine &command_line;
  MPI_Comm communicator;
  const AnalysisTable &analyses; ///< all that there are, for a study that performs others
};

/// What a case is read for.
CaseUse use_of(const CommandLine &command_line);

/**
 * What a parameter file asks for. The constructor of a derived class reads and checks the input and
 * throws InputError; perform() does the work.
 */
class Analysis
{
public:
  explicit Analysis(const AnalysisInput &input);
  virtual ~Analysis() = default;
  Analysis(const Analysis &) = delete;
  Analysis &operator=(const Analysis &) = delete;

  /// Whether --restart goes on from a checkpoint in the output folder.
  virtual bool has_checkpoints() const { return false; }
  /// Whether a run can go on in the folder; throws InputError before anything is changed there. For
  /// an analysis with checkpoints.
  virtual void check_restart(const OutputDirectory & /*directory*/) const {}
  /// What perform() would do, a line each: analysis, model, discretisation, cells, steps, and
  /// what that will cost where it is known. Collective.
  virtual std::vector<std::string> outline() const;
  /// Writes the mesh that perform() would begin with to a .vtu file, on one rank. Throws InputError
  /// where there is no mesh, or several.
  virtual void write_mesh(const std::string &mesh_file);
  /// Whether the screen has its results in a table of its own, which the answer at the end need not
  /// repeat.
  virtual bool has_own_table() const { return false; }
  /// The quantities that its summary can state, known before.
  virtual QuantityNames quantity_names() const { return {}; }
  /// The memory that it may hold on all ranks together, by estimate [bytes]; 0: not known.
  /// Collective.
  virtual double estimated_memory() const { return 0.; }
  /// Opens the log in the folder, leaves there the resolved parameters and the user's files, and
  /// performs the analysis. `summary` is filled on the way, also of an analysis that fails; rank 0
  /// has all of it. Collective; throws RunError or Interrupted.
  void perform(const OutputDirectory &directory, Log &log, Summary &summary);

protected:
  ParameterFile &file;
  CommandLine command_line;
  MPI_Comm communicator;
  GeneralParameters general;

private:
  /// What every summary begins with; compute() sets `status` anew.
  void describe(Summary &summary) const;
  virtual void compute(const OutputDirectory &directory, Log &log, Summary &summary) = 0;
};
} // namespace Continua

#endif
