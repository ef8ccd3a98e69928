#include <continua/base/duration_text.h>
#include <continua/base/input_error.h>
#include <continua/base/log.h>
#include <continua/base/memory_limit.h>

#include <deal.II/base/mpi.h>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace Continua
{
namespace
{
using Clock = std::chrono::steady_clock;

double seconds_since(const Clock::time_point &start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}
} // namespace

struct Log::Implementation
{
  Implementation(const MPI_Comm communicator, const bool on_screen, const double report_interval)
      : writes(dealii::Utilities::MPI::this_mpi_process(communicator) == 0),
        on_screen(on_screen),
        // Open MPI's launcher gives rank 0 a terminal of its own, whether there is one behind it or
        // not.
        on_terminal(writes && isatty(STDOUT_FILENO) == 1 &&
                    std::getenv("OMPI_COMM_WORLD_RANK") == nullptr),
        progress_interval(on_terminal ? 0.2 : report_interval),
        start(Clock::now())
  {
  }

  void screen(const std::string &text)
  {
    clear_progress();
    std::cout << text << std::endl;
  }

  void to_file(const std::string &text)
  {
    if (!opened)
    {
      earlier_lines.push_back(text);
      return;
    }
    if (!file.is_open())
      return;
    file << text << std::endl;
    if (!file)
    {
      file.close();
      screen("warning: '" + file_name +
             "' cannot be written any more (is the disk full?); the lines go on here");
    }
  }

  void clear_progress()
  {
    if (!progress_shown)
      return;
    std::cout << "\r\033[K" << std::flush;
    progress_shown = false;
  }

  const bool writes;
  const bool on_screen;
  const bool on_terminal;
  const double progress_interval; ///< [s]
  const Clock::time_point start;

  std::string file_name;
  std::ofstream file;
  bool opened = false;
  std::vector<std::string> earlier_lines;
  std::vector<std::string> warnings;

  bool progress_shown = false;
  bool progress_started = false;
  Clock::time_point progress_start;
  Clock::time_point last_progress;
  double first_time = 0.;
  unsigned int first_step = 0;

  SectionTimer timer;
  MemoryUse memory_use;
};

Log::Log(const MPI_Comm communicator, const bool on_screen, const double report_interval)
    : implementation(std::make_unique<Implementation>(communicator, on_screen, report_interval))
{
  implementation->memory_use.mark("before the run"); // program, libraries, runs before
}

Log::~Log()
{
  end_progress();
}

void Log::open(const std::string &file, const bool append)
{
  Implementation &log = *implementation;
  if (!log.writes)
    return;
  log.file.open(file, append ? std::ios::app : std::ios::trunc);
  if (!log.file)
    throw RunError("cannot write '" + file + "': " + std::strerror(errno));
  log.file_name = file;
  log.opened = true;
  for (const std::string &text : log.earlier_lines)
    log.to_file(text);
  log.earlier_lines.clear();
}

void Log::line(const std::string &text)
{
  if (!implementation->writes)
    return;
  if (implementation->on_screen)
    implementation->screen(text);
  implementation->to_file(text);
}

void Log::detail(const std::string &text)
{
  if (implementation->writes)
    implementation->to_file(text);
}

void Log::note(const std::string &text)
{
  if (!implementation->writes)
    return;
  if (implementation->on_screen)
  {
    implementation->clear_progress();
    std::cerr << text << std::endl;
  }
  implementation->to_file(text);
}

void Log::warning(const std::string &text)
{
  std::vector<std::string> &all = implementation->warnings;
  if (std::find(all.begin(), all.end(), text) != all.end())
    return;
  all.push_back(text);
  line("warning: " + text);
}

void Log::resume_warnings(const std::vector<std::string> &earlier)
{
  std::vector<std::string> all = earlier;
  for (const std::string &text : implementation->warnings)
    if (std::find(all.begin(), all.end(), text) == all.end())
      all.push_back(text);
  implementation->warnings = all;
}

const std::vector<std::string> &Log::warnings() const
{
  return implementation->warnings;
}

void Log::progress(const double time, const double end_time, const unsigned int step)
{
  Implementation &log = *implementation;
  if (!log.on_terminal && !(log.writes && log.on_screen))
    return;
  if (!log.progress_started)
  {
    // The rate is that of this process: a restarted run does not count the steps before.
    log.progress_started = true;
    log.progress_start = Clock::now();
    log.first_time = time;
    log.first_step = step;
    log.last_progress = log.progress_start;
    if (!log.on_terminal)
      return;
  }
  else if (seconds_since(log.last_progress) < log.progress_interval)
    return;
  log.last_progress = Clock::now();

  const double elapsed = seconds_since(log.progress_start);
  const double done = (time - log.first_time) / (end_time - log.first_time);
  std::ostringstream text;
  text << std::setprecision(6) << "time " << time << " s of " << end_time << " s, step " << step;
  if (step > log.first_step && elapsed > 0.)
    text << ", " << std::setprecision(3) << (step - log.first_step) / elapsed << " steps/s";
  if (done > 0. && done <= 1. && elapsed > 0.)
    text << ", " << duration_text(elapsed * (1. - done) / done) << " left";
  if (!log.on_terminal)
  {
    std::cerr << text.str() << std::endl;
    return;
  }
  std::cout << "\r" << text.str() << "\033[K" << std::flush;
  log.progress_shown = true;
}

void Log::end_progress()
{
  implementation->clear_progress();
}

SectionTimer &Log::timer()
{
  return implementation->timer;
}

std::map<std::string, double> Log::wall_times() const
{
  std::map<std::string, double> result = implementation->timer.wall_times();
  result["total"] = seconds_since(implementation->start);
  return result;
}

void Log::timing_summary()
{
  const std::map<std::string, double> times = wall_times();
  std::size_t width = 0;
  for (const auto &section : times)
    width = std::max(width, section.first.size());
  const double total = times.at("total");
  detail("Wall time by section:");
  for (const auto &[name, seconds] : times)
  {
    std::ostringstream text;
    text << "  " << std::left << std::setw(static_cast<int>(width)) << name << std::right
         << std::fixed << std::setprecision(3) << std::setw(12) << seconds << " s"
         << std::setprecision(1) << std::setw(7) << 100. * seconds / total << " %";
    detail(text.str());
  }
}

MemoryUse &Log::memory_use()
{
  return implementation->memory_use;
}

void Log::memory_summary()
{
  if (memory_held() == 0.)
    return;
  std::size_t width = 0;
  for (const auto &[part, bytes] : memory_use().parts())
    width = std::max(width, part.size());
  detail("Memory by part (the program: " + memory_text(memory_held()) + " now, " +
         memory_text(peak_memory()) + " at most):");
  for (const auto &[part, bytes] : memory_use().parts())
  {
    std::ostringstream text;
    text << "  " << std::left << std::setw(static_cast<int>(width)) << part << std::right
         << std::fixed << std::setprecision(1) << std::setw(12) << bytes / 1e6 << " MB";
    detail(text.str());
  }
}
} // namespace Continua
