#ifndef continua_analysis_transient_h
#define continua_analysis_transient_h

#include <continua/analysis/step_attempts.h>
#include <continua/analysis/transient_checkpoint.h>
#include <continua/analysis/transient_progress.h>

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
  TransientProgress<dim> so_far;
  StepAttempts<dim> attempts;
  TransientCheckpoint<dim> checkpoint;
  unsigned int tenths_reported = 0;

  void step();
  /// Throws RunError if the velocity in a part of a step is above its limit.
  void check_velocity(const StepReport &report, const Step &part) const;
  unsigned int tenths_of_end() const;
  void report_progress();
};
} // namespace Continua

#endif
