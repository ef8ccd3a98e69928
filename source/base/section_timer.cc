#include <continua/base/section_timer.h>

#include <deal.II/base/exceptions.h>

#include <ctime>

namespace Continua
{
namespace
{
/// Of this process [s].
double processor_time()
{
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}
} // namespace

std::size_t SectionTimer::find(const char *const section)
{
  std::size_t number = 0;
  while (number < sections.size() && sections[number].name != section)
    ++number;
  if (number == sections.size())
  {
    sections.emplace_back();
    sections.back().name = section;
  }
  return number;
}

void SectionTimer::start(const std::size_t number)
{
  Section &section = sections[number];
  Assert(!section.is_running,
         dealii::ExcMessage("The section '" + section.name + "' runs already."));
  section.is_running = true;
  if (takes_processor_times)
    section.processor_start = processor_time();
  section.wall_start = Clock::now();
}

void SectionTimer::stop(const std::size_t number)
{
  Section &section = sections[number];
  Assert(section.is_running, dealii::ExcMessage(section.name + " is left and was not entered"));
  section.is_running = false;
  section.wall_time += std::chrono::duration<double>(Clock::now() - section.wall_start).count();
  if (takes_processor_times)
    section.processor_time += processor_time() - section.processor_start;
}

std::map<std::string, double> SectionTimer::wall_times() const
{
  std::map<std::string, double> times;
  for (const Section &section : sections)
    times[section.name] = section.wall_time;
  return times;
}

std::map<std::string, double> SectionTimer::processor_times() const
{
  std::map<std::string, double> times;
  for (const Section &section : sections)
    times[section.name] = section.processor_time;
  return times;
}
} // namespace Continua
