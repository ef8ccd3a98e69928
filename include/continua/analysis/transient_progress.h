#ifndef continua_analysis_transient_progress_h
#define continua_analysis_transient_progress_h

#include <continua/analysis/flow_report.h>
#include <continua/analysis/periodic_state.h>
#include <continua/analysis/range_report.h>
#include <continua/analysis/record_table.h>
#include <continua/analysis/run.h>
#include <continua/time_integration/time_control.h>

#include <vector>

namespace Continua
{
/// A run in time as far as it has come: what its steps change, and a checkpoint holds.
template <int dim>
struct TransientProgress
{
  /// `run` must outlive it.
  explicit TransientProgress(Run<dim> &run);

  Run<dim> &run;
  TimeControl time_control;
  std::vector<ScheduledRecord<dim>> records;
  FlowReport<dim> flow;
  RangeReport<dim> range;
  PeriodicState<dim> beats;
  Schedule probe_schedule;
  bool mesh_has_changed = false;
  double last_size = 0.;      ///< [s] of the step that led here
  double largest_energy = 0.; ///< of the body so far, where the time step adapts [J]
  unsigned long n_halved = 0; ///< steps, and halves of them, without a solution

  /// Whether the end time has come, or the beats have settled.
  bool at_end() const { return time_control.at_end() || beats.ends_run(); }
  /// Writes the probes' row of the end of a step.
  void record_probes();
  bool adaptation_is_due() const;
  void adapt();
};
} // namespace Continua

#endif
