#ifndef continua_benchmarks_measurement_h
#define continua_benchmarks_measurement_h

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace Benchmarks
{
double median(std::vector<double> values);
/// Wall time of one call [s].
double wall_time(const std::function<void()> &function);
/// Processor time of one call in this process [s]: unlike wall time it does not grow when other
/// processes wait for the same core.
double processor_time(const std::function<void()> &function);

/// a(i) = b(i) + 3 c(i) over three arrays of 64 MiB, on one core.
class Triad
{
public:
  Triad();
  /// Bytes a second of processor time in one sweep, counting two reads and one write.
  double bandwidth();

private:
  std::vector<double> a, b, c;
};

/// "AMD EPYC ..." of /proc/cpuinfo.
std::string processor();
/// Load average of the last minute, of /proc/loadavg.
double load();

/// A number with three significant digits, as short as it gets.
std::string number(double value);

/// What one benchmark tells: lines about machine and conditions, and tables of text cells.
class Report
{
public:
  explicit Report(std::string title);
  void line(const std::string &text);
  void start_table(const std::string &heading, const std::vector<std::string> &columns);
  void row(const std::vector<std::string> &cells);
  /// Writes what there is so far, as finish() does: a long benchmark that is stopped leaves it.
  void save(const std::string &path) const;
  /// Prints as plain text on the screen and writes `path`.txt and `path`.md. Throws
  /// std::runtime_error if a file cannot be written.
  void finish(const std::string &path) const;

private:
  struct Table
  {
    std::string heading;
    std::vector<std::vector<std::string>> rows; ///< the first one names the columns
  };
  std::string title;
  std::vector<std::string> lines;
  std::vector<Table> tables;

  std::string text() const;
  std::string markdown() const;
};

/// The lines that a benchmark begins with: processor and load; and, of one that solves in its own
/// process, the version and its libraries.
void describe_machine(Report &report);
void describe_libraries(Report &report);

/// The main function of a benchmark of `OUTPUT SOURCE_DIRECTORY`, and of an option if it has one:
/// MPI, the arguments, errors on the screen. `run`: whether the option is given comes last.
int main_of(int argc,
            char **argv,
            const std::function<void(const std::string &, const std::string &, bool)> &run,
            const std::string &option = "");
} // namespace Benchmarks

#endif
