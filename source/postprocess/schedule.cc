#include <continua/postprocess/schedule.h>

#include <cmath>

namespace Continua
{
Schedule::Schedule(const double interval,
                   const ZeroInterval zero,
                   const double end_time,
                   const bool first,
                   const bool last)
    : interval(interval), zero(zero), end_time(end_time), first(first), last(last)
{
}

bool Schedule::due(const double time, const double step_size) const
{
  // A time that is meant to be a multiple of the interval may be so but for round-off.
  const double tolerance = 1e-6 * step_size;
  if (last && time >= end_time - tolerance)
    return true;
  if (step_size == 0.)
    return first;
  if (interval == 0.)
    return zero == ZeroInterval::every_step;
  const double now = std::floor((time + tolerance) / interval);
  const double before = std::floor((time - step_size + tolerance) / interval);
  return now > before;
}
} // namespace Continua
