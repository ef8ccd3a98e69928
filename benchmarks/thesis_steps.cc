// The thesis's longest run, 3e5 steps of its 40 x 10 beam, as a user runs it: the whole process
// with all it writes.
//
//   benchmark_thesis_steps OUTPUT PROGRAM SOURCE_DIRECTORY
//
// writes OUTPUT.txt and OUTPUT.md, and the run's own files to OUTPUT-run.

#include "measurement.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <sys/resource.h>

namespace Benchmarks
{
void run(const std::string &output, const std::string &program, const std::string &source_directory)
{
  Report report("The thesis's 300,000 steps");
  describe_machine(report);
  const std::string parameter_file = "parameter_files/thesis/chapter-4/beam-euler-30s.prm";
  report.line("run: continua " + parameter_file);

  const std::string folder = output + "-run";
  const std::string command = "'" + program + "' '" + source_directory + "/" + parameter_file +
                              "' --output '" + folder + "' --overwrite > /dev/null";
  const double wall = wall_time(
      [&]()
      {
        if (std::system(command.c_str()) != 0)
          throw std::runtime_error("the run failed: " + command);
      });
  rusage usage;
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval &time)
  { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  const double processor_time = seconds(usage.ru_utime) + seconds(usage.ru_stime);

  std::ifstream stream(folder + "/summary.json");
  const nlohmann::json summary = nlohmann::json::parse(stream);
  const double n_steps = summary.at("steps").get<double>();
  report.line("version: " + summary.at("version").get<std::string>() + ", revision " +
              summary.at("revision").get<std::string>());
  report.line("BLAS: " + summary.at("libraries").at("BLAS").get<std::string>());
  report.line("load at the end: " + number(load()));
  report.start_table("The whole process", {"steps", "wall [s]", "processor [s]",
                                           "wall of a step [ms]", "peak memory [MB]"});
  report.row({std::to_string(static_cast<long>(n_steps)), number(wall), number(processor_time),
              number(1e3 * wall / n_steps), number(1e-3 * static_cast<double>(usage.ru_maxrss))});
  report.start_table("Where the time goes", {"section", "wall [s]", "share [%]"});
  for (const auto &section : summary.at("wall time [s]").items())
  {
    const double time = section.value().get<double>();
    report.row({section.key(), number(time), number(100. * time / wall)});
  }
  report.finish(output);
}
} // namespace Benchmarks

int main(int argc, char **argv)
{
  if (argc != 4)
  {
    std::cerr << "usage: " << argv[0] << " OUTPUT PROGRAM SOURCE_DIRECTORY" << std::endl;
    return 2;
  }
  try
  {
    Benchmarks::run(argv[1], argv[2], argv[3]);
  }
  catch (const std::exception &error)
  {
    std::cerr << "error: " << error.what() << std::endl;
    return 1;
  }
}
