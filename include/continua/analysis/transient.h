#ifndef continua_analysis_transient_h
#define continua_analysis_transient_h

#include <continua/analysis/checkpoint.h>
#include <continua/analysis/flow_report.h>
#include <continua/analysis/periodic_state.h>
#include <continua/analysis/range_report.h>
#include <continua/analysis/record_table.h>
#include <continua/analysis/run.h>
#include <continua/time_integration/time_control.h>

#include <chrono>
#include <string>
#include <vector>

namespace Continua
{
/// Steps through time, with probes, records, adaptive mesh and checkpoints on the way.
template <int dim>
class Transient
{
public:
  explicit Transient(Run<dim> &run);
  void perform();

  /// Whether wave theory can stand beside the run as the file asks. Throws InputError.
  static void check(const Case<dim> &input, ParameterSection root);
  static void name_quantities(const Case<dim> &input, QuantityNames &names);

private:
  Run<dim> &run;
  TimeControl time_control;
  std::vector<ScheduledRecord<dim>> records;
  FlowReport<dim> flow;
  RangeReport<dim> range;
  PeriodicState<dim> beats;
  Checkpoint checkpoint;
  Schedule probe_schedule, checkpoint_schedule;
  bool mesh_has_changed = false;
  double last_size = 0.;      ///< [s] of the step that led here
  double largest_energy = 0.; ///< of the body so far, where the time step adapts [J]
  unsigned int tenths_reported = 0;
  unsigned long n_restarts = 0;
  Step last_part;                ///< that was made
  bool step_is_divided = false;  ///< the present step is made in halves, since it had no solution
  unsigned long n_halved = 0;    ///< steps, and halves of them, without a solution
  Checksum of_log;               ///< of log.txt as it was at the last checkpoint
  double earlier_wall_time = 0.; ///< [s] of the run before the restart
  std::chrono::steady_clock::time_point last_checkpoint = std::chrono::steady_clock::now();

  /// Whether the end time has come, or the beats have settled.
  bool at_end() const { return time_control.at_end() || beats.ends_run(); }
  void start();
  /// Finds the steady state that the file asks for at t = 0, under the loads there or their mean.
  void start_steady_under_loads();
  /// Changes the mesh before the first step, as often as the file asks.
  void adapt_before_start();
  /// Which boundaries begin with a value that a body at rest meets as a jump.
  void report_initial_jumps();
  /// On several ranks: how the run is ended with a checkpoint.
  void report_how_to_stop();
  /// Says the periods of tables, and warns of what they leave open.
  void report_tables();
  /// What linear theory says of a run with fluid and solid, and the numbers of a flow.
  void report_preflight();
  void restart();
  void step();
  /// Starts the scheme anew if something jumps in the step that comes next.
  void find_jumps();
  StepReport advance(const Step &part);
  /// Writes the probes' row of the end of a step.
  void record_probes();
  /// The next time step in parts, in reverse.
  std::vector<Step> next_parts();
  /// Makes the last of the parts, which becomes `last_part`. A part without a solution is halved,
  /// and its halves take its place; an adaptive step is begun anew with a smaller size, as long as
  /// none of its parts is made. Throws RunError after six halvings.
  StepReport make_next_part(std::vector<Step> &parts, bool is_first);
  /// Whether the step that was made last is good enough; else time is at its start again.
  bool stands();
  bool adaptation_is_due() const;
  void adapt();
  /// Writes a checkpoint if one is due; also ends the run if a signal asks for it.
  void save_or_stop();
  void write_checkpoint();
  void flush_log_to_disk();
  /// What a restart continues, on rank 0.
  std::vector<WrittenTable> written_tables() const;
  void report_progress();
};
} // namespace Continua

#endif
