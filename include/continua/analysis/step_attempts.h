#ifndef continua_analysis_step_attempts_h
#define continua_analysis_step_attempts_h

#include <continua/analysis/transient_progress.h>
#include <continua/base/input_error.h>
#include <continua/time_integration/step.h>

#include <vector>

namespace Continua
{
/**
 * Makes the steps of a run in time, each in the parts that it needs. A part without a solution is
 * halved, and its halves take its place; an adaptive step is begun anew with a smaller size where
 * its error is too large or it has no solution, as long as none of its parts stands.
 */
template <int dim>
class StepAttempts
{
public:
  /// Must outlive it.
  explicit StepAttempts(TransientProgress<dim> &so_far);

  /// Begins a step, starting the scheme anew if something jumps in it, and makes its first part
  /// until that stands. Throws RunError after six halvings.
  StepReport begin();
  /// Whether the step has further parts, and makes the next one of them.
  bool has_next_part() const { return !parts.empty(); }
  StepReport make_next_part() { return make_part(false); }
  const Step &last_part() const { return part; } ///< that was made
  /// Whether the step was made in halves, since it had no solution.
  bool is_divided() const { return divided; }

private:
  TransientProgress<dim> &so_far;
  Run<dim> &run;
  std::vector<Step> parts; ///< of the present step that are left, the next one last
  Step part;
  bool divided = false;

  void find_jumps();
  void take_next_parts();
  StepReport make_part(bool is_first);
  /// Halves the last part, which has failed.
  void divide(const StepFailure &failure);
  /// Whether the step that was made last is good enough; else time is at its start again.
  bool stands();
  StepReport advance();
};
} // namespace Continua

#endif
