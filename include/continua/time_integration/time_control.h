#ifndef continua_time_integration_time_control_h
#define continua_time_integration_time_control_h

#include <continua/base/archive.h>
#include <continua/base/words.h>
#include <continua/time_integration/step.h>
#include <continua/time_integration/step_size_control.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Continua
{
enum class Scheme
{
  euler_implicit,
  backward_differencing,
  crank_nicolson
};

const Words<Scheme> &scheme_words();
/// "automatic" has no value: the scheme sets the update.
const Words<std::optional<Update>> &update_words();

enum class StepControl
{
  fixed,   ///< every step has the size given
  adaptive ///< its size follows an estimate of its local error
};

/// The section Time.
struct TimeParameters
{
  Scheme scheme = Scheme::backward_differencing;
  std::optional<Update> update;                   ///< none: the scheme sets it
  double time_step = 0.;                          ///< [s]
  double end_time = 0.;                           ///< [s]
  std::vector<std::pair<double, double>> changes; ///< (time [s], new step [s]), in order
  std::vector<double> jump_times; ///< [s] at which a load or a prescribed velocity jumps
  bool smooth_start = true;
  double velocity_limit = 1e9; ///< [m/s]; a run that exceeds it has diverged
  StepControl step_control = StepControl::fixed;
  // Of an adaptive step, of which time_step is the first:
  double error_tolerance = 1e-4; ///< of the local error of a step's velocity [1]
  double least_step = 0.;        ///< [s]; 0: a 64th of the first
  double largest_step = 0.;      ///< [s]; 0: 64 times the first
  unsigned int steps_between_increases = 10;

  /// Declares and reads; throws InputError.
  void read(ParameterSection section);
  bool is_adaptive() const { return step_control == StepControl::adaptive; }
  /// The smallest of the run's time steps, or what an adaptive one may become [s].
  double smallest_step() const;
  StepSizeParameters step_sizes() const;
  /// Where the scheme sets the update and it is the trapezoidal one, takes the implicit one.
  void take_implicit_update();
  /// `update`, or what the scheme sets.
  Update update_type() const;
};

/**
 * Where the run is in time, and the coefficients of its next step. Time is counted in whole steps
 * from the last change of the step size, so that it does not drift over long runs. A start, a jump
 * and a change of the mesh are followed by backward Euler: one step for backward differencing, and
 * for Crank-Nicolson two steps of two halves each with the same matrix (Rannacher, Numer. Math. 43,
 * 1984).
 *
 * An adaptive step is judged by its local error after it has been made. Its sizes are the first one
 * times a power of two; before a jump time and the end it becomes as much smaller as leads there,
 * but not smaller than any before it and the first one. A change of its size costs backward
 * differencing no matrix of its own: the older state is moved to the new distance instead, see
 * Step::older_distance.
 */
class TimeControl
{
public:
  explicit TimeControl(const TimeParameters &parameters);

  double time() const;
  double end_time() const { return parameters.end_time; }
  unsigned int n_steps() const { return now.step_number; }
  bool is_adaptive() const { return parameters.is_adaptive(); }
  /// The size of the last step [s].
  double last_size() const { return now.size_old; }
  bool at_end() const;
  /// The size of the step that comes next [s].
  double next_size() const;

  /// The next time step as one step, or as two halves; moves on by it.
  std::vector<Step> next();

  /**
   * Of an adaptive step: takes the relative local error [1] of the step that next() gave last;
   * without a value it is not known, and the size stays. Returns false if the step is to be made
   * again: time is then at its start once more, and next() gives a shorter one.
   */
  bool judge(const std::optional<double> &error);

  /// The last step was made in parts, the last of them of this size [s].
  void set_last_size(const double size) { now.size_old = size; }

  /// The solution is not smooth here: the mesh has changed.
  void restart();
  /// A load jumps in the step that comes next. An adaptive step longer than the first one becomes
  /// that one, without a new start, and the answer is false: see where it jumps then.
  bool jump();

  const StepSizeControl &sizes() const { return size_control; }

  void save(ArchiveWriter &archive) const;
  void load(const ArchiveReader &archive);

private:
  /// Where the run is.
  struct Position
  {
    unsigned int step_number = 0;
    double segment_start = 0.;
    double segment_size = 0.; ///< of its steps [s]
    unsigned int steps_in_segment = 0;
    unsigned int n_changes_done = 0;
    unsigned int n_jumps_done = 0;
    unsigned int smooth_steps = 0; ///< since the start, jump or mesh change
    double size_old = 0.;
  };
  TimeParameters parameters;
  StepSizeControl size_control;
  Position now, before;  ///< the last step
  int last_exponent = 0; ///< of its size, if it is adaptive

  double tolerance() const;
  int next_exponent() const;
  void begin_segment(double size);
  void apply_changes();
};
} // namespace Continua

#endif
