#include "../unit_test.h"

#include <continua/postprocess/schedule.h>

namespace test_of_schedule
{
using Continua::Schedule;

namespace
{
/// How often something is due in `n_steps` steps from time `start`, the initial state not counted.
unsigned int
count(const Schedule &schedule, const double start, const double step_size, const int n_steps)
{
  unsigned int n_due = 0;
  for (int n = 1; n <= n_steps; ++n)
    n_due += schedule.due(start + n * step_size, step_size) ? 1 : 0;
  return n_due;
}
} // namespace

UNIT_TEST(schedule)
{
  using Zero = Schedule::ZeroInterval;
  const double step = 0.1; // not exact in binary

  // A million steps, every third.
  const Schedule third(0.3, Zero::never, 1e5, false, false);
  check::absolute("no drift", count(third, 0., step, 999999), 333333., 0.);
  check::is_true("not between", !third.due(0.1, step) && !third.due(0.2, step));
  check::is_true("at the multiple", third.due(0.1 + 0.1 + 0.1, step));

  // Two runs, the second from a checkpoint, write as often as one: 100 + 233 = 333.
  check::absolute("before the restart", count(third, 0., step, 300), 100., 0.);
  check::absolute("after the restart", count(third, 30., step, 699), 233., 0.);

  // An interval that is no multiple of the step: multiples of 0.25 up to 10 are 40 in number.
  check::absolute("between steps", count({0.25, Zero::never, 1e5, false, false}, 0., step, 100),
                  40., 0.);
  check::absolute("interval below the step",
                  count({0.01, Zero::never, 1e5, false, false}, 0., step, 100), 100., 0.);

  const Schedule ends(4., Zero::never, 10., true, true);
  check::is_true("first", ends.due(0., 0.));
  check::is_true("last", ends.due(10., step) && ends.due(10. - 1e-12, step));
  check::absolute("first and last between", count(ends, 0., step, 100), 3., 0.);
  check::is_true("no first", !Schedule(4., Zero::never, 10., false, true).due(0., 0.));
  check::is_true("no last", !Schedule(4., Zero::never, 10., true, false).due(10., step));

  check::absolute("every step", count({0., Zero::every_step, 10., true, true}, 0., step, 100), 100.,
                  0.);
  check::absolute("never", count({0., Zero::never, 10., false, false}, 0., step, 100), 0., 0.);
  check::is_true("steady", Schedule(0., Zero::never, 0., false, true).due(0., 0.));
}
} // namespace test_of_schedule
