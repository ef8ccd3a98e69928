#ifndef continua_analysis_run_h
#define continua_analysis_run_h

#include <continua/base/citations.h>
#include <continua/base/log.h>
#include <continua/base/output_directory.h>
#include <continua/base/summary.h>
#include <continua/case/case.h>
#include <continua/continuum/continuum_solver.h>

#include <functional>
#include <memory>
#include <string>

namespace Continua
{
/**
 * One computation of one case: the case, its solver on the refined mesh, where it writes, and the
 * summary that it ends with. All analyses of a case have this in common; Transient, Steady, Modal
 * and LinearWaveTheory perform a run.
 */
template <int dim>
class Run
{
public:
  Run(Case<dim> &input,
      const ParameterFile &file,
      const CommandLine &command_line,
      const OutputDirectory &directory,
      Log &log,
      Summary &summary);

  /// Refines the mesh as the file asks, or by `make_mesh`, sets the solver up and attaches the
  /// probes.
  void initialise(const std::function<void()> &make_mesh = {});
  /// Changes the mesh by the indicators at `time` [s] and carries the state over; returns whether
  /// it changed. Where no indicator looks at the solution it is changed until it fits.
  bool adapt(double time);
  /// Changes the mesh before the start: once, and the state is the initial one on the new mesh.
  /// Returns whether it changed; if not, the state stays as it is.
  bool adapt_before_start();
  /// The quantities, checks and summary of a finished run.
  void finish(unsigned int n_steps, double time);
  /// The summary of a run that failed, or was interrupted, with the reason.
  void fail(const std::string &reason);
  void interrupt(const std::string &reason);
  /// The names of the quantities that initialise() and finish() add.
  static void name_quantities(const Case<dim> &input, QuantityNames &names);

  Case<dim> &input;
  const ParameterFile &file;
  const CommandLine &command_line;
  const OutputDirectory &directory;
  Log &log;
  Summary &summary;
  std::unique_ptr<ContinuumSolver<dim>> solver;
  Citations citations;
  bool is_writer; ///< rank 0

private:
  /// Flags cells by the indicators; returns whether any is.
  bool flag(double time);
  void describe_run();
  /// Lines of the log on walls that relax in finite deformation.
  void report_strain_laws();
  void write_summary(const std::string &status);
  /// How much of the wall time probes, fields and checkpoints took, on rank 0.
  void report_output_share();
};
} // namespace Continua

#endif
