#ifndef continua_base_section_timer_h
#define continua_base_section_timer_h

#include <chrono>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace Continua
{
/**
 * Wall time by section of a program. A scope reads the clock twice and nothing else, since a step
 * of a small problem has several of them: deal.II's TimerOutput also asks the system for the
 * processor time, which takes longer than many a section. Sections may be within others and count
 * by themselves. One thread.
 */
class SectionTimer
{
public:
  /// While it lives, time counts as that of the section.
  class Scope
  {
  public:
    Scope(SectionTimer &timer, const char *section) : timer(timer), number(timer.find(section))
    {
      timer.start(number);
    }
    ~Scope() { timer.stop(number); }
    Scope(const Scope &) = delete;
    Scope &operator=(const Scope &) = delete;

  private:
    SectionTimer &timer;
    const std::size_t number;
  };

  void enter_subsection(const char *section) { start(find(section)); }
  void leave_subsection(const char *section) { stop(find(section)); }
  /// From now on the processor time of this process is taken, too; for benchmarks.
  void take_processor_times() { takes_processor_times = true; }

  std::map<std::string, double> wall_times() const;      ///< by section [s]
  std::map<std::string, double> processor_times() const; ///< since they are taken [s]

private:
  using Clock = std::chrono::steady_clock;
  struct Section
  {
    std::string name;
    double wall_time = 0., processor_time = 0.; ///< [s]
    Clock::time_point wall_start = {};
    double processor_start = 0.;
    bool is_running = false;
  };
  std::vector<Section> sections;
  bool takes_processor_times = false;

  /// Makes a section that is new.
  std::size_t find(const char *section);
  void start(std::size_t number);
  void stop(std::size_t number);
};
} // namespace Continua

#endif
