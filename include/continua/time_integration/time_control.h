#ifndef continua_time_integration_time_control_h
#define continua_time_integration_time_control_h

#include <continua/base/archive.h>
#include <continua/base/parameter_section.h>
#include <continua/time_integration/step.h>

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

/// The section Time.
struct TimeParameters
{
  std::string scheme = "backward differencing";
  std::string update = "automatic";
  double time_step = 0.;                          ///< [s]
  double end_time = 0.;                           ///< [s]
  std::vector<std::pair<double, double>> changes; ///< (time [s], new step [s]), in order
  std::vector<double> jump_times; ///< [s] at which a load or a prescribed velocity jumps
  bool smooth_start = true;
  double velocity_limit = 1e9; ///< [m/s]; a run that exceeds it has diverged

  /// Declares and reads; throws InputError.
  void read(ParameterSection section);
  /// The smallest of the run's time steps [s].
  double smallest_step() const;
  Scheme scheme_type() const;
  Update update_type() const;
};

/**
 * Where the run is in time, and the coefficients of its next step. Time is counted in whole steps
 * from the last change of the step size, so that it does not drift over long runs. A start, a jump
 * and a change of the mesh are followed by backward Euler: one step for backward differencing, and
 * for Crank-Nicolson two steps of two halves each with the same matrix (Rannacher, Numer. Math. 43,
 * 1984).
 */
class TimeControl
{
public:
  explicit TimeControl(const TimeParameters &parameters);

  double time() const;
  double end_time() const { return parameters.end_time; }
  unsigned int n_steps() const { return step_number; }
  bool at_end() const;
  /// The size of the step that comes next [s].
  double next_size() const;

  /// The next time step as one step, or as two halves; moves on by it.
  std::vector<Step> next();

  /// The solution is not smooth here: a load has jumped, or the mesh has changed.
  void restart();

  void save(ArchiveWriter &archive) const;
  void load(const ArchiveReader &archive);

private:
  TimeParameters parameters;
  unsigned int step_number = 0;
  double segment_start = 0.;
  unsigned int steps_in_segment = 0;
  unsigned int n_changes_done = 0;
  unsigned int n_jumps_done = 0;
  unsigned int smooth_steps = 0; ///< since the start, jump or mesh change
  double size_old = 0.;

  void apply_changes();
};
} // namespace Continua

#endif
