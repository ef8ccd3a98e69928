#ifndef continua_postprocess_schedule_h
#define continua_postprocess_schedule_h

namespace Continua
{
/**
 * When something is written: at whole multiples of an interval, or after the step that passes one.
 * It remembers nothing and is a function of the time alone, so that it neither drifts nor needs to
 * be saved for a restart.
 */
class Schedule
{
public:
  enum class ZeroInterval
  {
    never,
    every_step
  };
  /// `interval` and `end_time` in s. `first`: the initial state counts; `last`: the state at the
  /// end counts, even where the interval says no.
  Schedule(double interval, ZeroInterval zero, double end_time, bool first, bool last);

  /// Whether to write the state at `time` [s] that a step of `step_size` [s] has led to; the
  /// initial state, to which no step has led, has size 0.
  bool due(double time, double step_size) const;
  /// Whether the state at the end counts, at whatever time a run ends.
  bool takes_end() const { return last; }

private:
  double interval;
  ZeroInterval zero;
  double end_time;
  bool first;
  bool last;
};
} // namespace Continua

#endif
