#include <continua/base/child_process.h>
#include <continua/base/input_error.h>
#include <continua/base/input_file.h>
#include <continua/base/parameter_file.h>
#include <continua/base/parameter_text.h>
#include <continua/postprocess/report_entry.h>
#include <continua/postprocess/writing_rank.h>
#include <continua/program/run_report.h>
#include <continua/program/script.h>

#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <thread>

namespace Continua
{
namespace
{
constexpr std::chrono::milliseconds pause_of_ranks(20);
/// A report takes seconds; a machine that is busy with other work may need minutes [s].
constexpr double longest_time = 3600.;

/// What the script prints; gone with the object.
class ScreenOfScript
{
public:
  ScreenOfScript()
      : name((std::filesystem::temp_directory_path() / "continua-report-XXXXXX").string())
  {
    const int file = ::mkstemp(name.data());
    if (file < 0)
      throw RunError("no file can be made in " + std::filesystem::temp_directory_path().string() +
                     ": " + std::strerror(errno));
    ::close(file);
  }
  ~ScreenOfScript() { std::remove(name.c_str()); }
  ScreenOfScript(const ScreenOfScript &) = delete;
  ScreenOfScript &operator=(const ScreenOfScript &) = delete;

  const std::string &file() const { return name; }
  std::string last_line() const
  {
    std::istringstream lines(read_input_file(name));
    std::string last;
    for (std::string line; std::getline(lines, line);)
      if (!collapse_blanks(line).empty())
        last = collapse_blanks(line);
    return last;
  }

private:
  std::string name;
};

/// What the script says: where the report is. Throws std::exception if there is none.
std::string perform_script(const std::string &folder)
{
  const ScreenOfScript screen;
  ChildProcess::Program program;
  program.file = script_file("report");
  program.arguments = {program.file, folder};
  program.environment = environment_without_launcher();
  // It draws the mesh by the program: by this one, where the user names no other.
  if (std::getenv("CONTINUA_PROGRAM") == nullptr)
    program.environment.push_back("CONTINUA_PROGRAM=" +
                                  std::filesystem::read_symlink("/proc/self/exe").string());
  program.screen = screen.file();
  if (!std::filesystem::exists(program.file))
    throw RunError(program.file + " is not there");
  const int status = ChildProcess(program).wait(longest_time).exit_status();
  const std::string said = screen.last_line();
  if (status != 0)
    throw RunError(said.empty() ? program.file + " ended with the status " + std::to_string(status)
                                : said);
  return said;
}
} // namespace

bool asks_for_report(ParameterFile &file)
{
  return read_report_entry(file.root().subsection("Output"));
}

void make_report(const std::string &folder, const MPI_Comm communicator)
{
  if (is_writing_rank(communicator))
    try
    {
      const std::string said = perform_script(folder);
      std::cout << "Report: " << printable(said) << std::endl;
    }
    catch (const std::exception &error)
    {
      std::cerr << "warning: Output/Report: there is no report, since "
                << printable(collapse_blanks(error.what()))
                << ". The run is finished; where Python, VTK and Matplotlib are, 'continua report "
                << printable(folder) << "' makes the report" << std::endl;
    }
  MPI_Request request;
  MPI_Ibarrier(communicator, &request);
  for (int done = 0; done == 0;)
  {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done == 0)
      std::this_thread::sleep_for(pause_of_ranks);
  }
}
} // namespace Continua
