#ifndef continua_analysis_transient_start_h
#define continua_analysis_transient_start_h

#include <continua/analysis/transient_progress.h>

namespace Continua
{
/// What a run in time does and says before its first step.
template <int dim>
class TransientStart
{
public:
  /// Must outlive it.
  explicit TransientStart(TransientProgress<dim> &so_far);

  /// Says the periods of tables and what they leave open, and what the time steps do.
  void report_input();
  /// Sets the body up with the state of t = 0, and opens the records.
  void start();
  /// What linear theory says of a run with fluid and solid, and the numbers of a flow.
  void report_preflight();

private:
  TransientProgress<dim> &so_far;
  Run<dim> &run;

  void report_tables();
  /// On several ranks: how the run is ended with a checkpoint.
  void report_how_to_stop();
  /// Finds the steady state that the file asks for at t = 0, under the loads there or their mean.
  void start_steady_under_loads();
  /// Changes the mesh before the first step, as often as the file asks.
  void adapt_before_start();
  /// Which boundaries begin with a value that a body at rest meets as a jump.
  void report_initial_jumps();
};
} // namespace Continua

#endif
