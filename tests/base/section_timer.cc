// Wall times by section: sections add up, one within another counts by itself, and a section can be
// left for another one and entered again.

#include <continua/base/section_timer.h>

#include "../unit_test.h"

#include <ctime>
#include <unistd.h>

namespace test_of_section_timer
{
namespace
{
/// Waits without working [ms].
void wait(const unsigned int milliseconds)
{
  usleep(1000 * milliseconds);
}

/// Works for this processor time [s].
void work(const double seconds)
{
  const std::clock_t begin = std::clock();
  while (static_cast<double>(std::clock() - begin) < seconds * CLOCKS_PER_SEC)
    ;
}
} // namespace

UNIT_TEST(section_timer)
{
  using namespace Continua;
  SectionTimer timer;
  check::is_true("nothing at first", timer.wall_times().empty());
  for (unsigned int i = 0; i < 2; ++i)
  {
    const SectionTimer::Scope outer(timer, "outer");
    wait(10);
    {
      const SectionTimer::Scope inner(timer, "inner");
      wait(20);
    }
    // What is within a solve counts as a factor.
    timer.leave_subsection("outer");
    timer.enter_subsection("other");
    wait(30);
    timer.leave_subsection("other");
    timer.enter_subsection("outer");
  }
  const std::map<std::string, double> times = timer.wall_times();
  check::is_true("three sections", times.size() == 3);
  check::is_true("inner", times.at("inner") >= 0.04);
  check::is_true("outer, with what is within it", times.at("outer") >= times.at("inner") + 0.02);
  check::is_true("other, which is not within it", times.at("other") >= 0.06);

  timer.take_processor_times();
  {
    const SectionTimer::Scope outer(timer, "outer");
    wait(50);
    work(0.01);
  }
  const double processor_time = timer.processor_times().at("outer");
  check::is_true("who waits takes no processor time",
                 processor_time >= 0.01 && processor_time < 0.05);
}
} // namespace test_of_section_timer
