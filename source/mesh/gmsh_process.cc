#include <continua/base/child_process.h>
#include <continua/base/input_file.h>
#include <continua/mesh/gmsh_process.h>
#include <continua/mesh/system_call_filter.h>

#include <gmsh.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <new>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <vector>

namespace Continua
{
namespace
{
const std::string gmsh_process_argument = "--continua-internal-mesh-with-gmsh";
constexpr int n_arguments = 6; // program, the hidden one, file, dimension, mesh file, commands

/// A folder of its own for the files of the process.
struct TemporaryFolder
{
  TemporaryFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "continua-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("no folder can be made in " +
                               std::filesystem::temp_directory_path().string() + ": " +
                               std::strerror(errno));
    path = name;
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  std::filesystem::path path;
};

/// The last lines that the process has printed, as one: "LINE; LINE".
std::string last_lines(const std::string &log)
{
  constexpr std::size_t n_most = 3, longest = 400;
  std::istringstream stream(read_input_file(log));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    if (!line.empty())
      lines.push_back(printable(line.substr(0, longest)));
  std::string text;
  for (std::size_t i = lines.size() - std::min(lines.size(), n_most); i < lines.size(); ++i)
    text += (text.empty() ? "" : "; ") + lines[i];
  return text;
}

/// What gmsh throws is a text or an exception, by its version.
template <typename Function>
std::string error_of(const Function &function)
{
  try
  {
    function();
    return "";
  }
  catch (const std::string &message)
  {
    return message.empty() ? "no reason is known" : message;
  }
  catch (const std::bad_alloc &)
  {
    return "it needs more memory than it may take (" +
           std::to_string(memory_limit_of_gmsh() >> 20) + " MiB)";
  }
  catch (const std::exception &exception)
  {
    return exception.what();
  }
}

void refuse_points_at_infinity()
{
  gmsh::vectorpair points;
  gmsh::model::getEntities(points, 0);
  for (const auto &[dimension, tag] : points)
  {
    std::vector<double> place;
    gmsh::model::getValue(dimension, tag, {}, place);
    if (!std::all_of(place.begin(), place.end(), [](const double x) { return std::isfinite(x); }))
      throw std::runtime_error("a coordinate of Point(" + std::to_string(tag) +
                               ") is no finite number");
  }
}

/// Reads the file and makes the mesh, in memory.
void make_mesh(const std::string &geo_file, const int dimension)
{
  gmsh::open(geo_file);
  refuse_points_at_infinity();
  gmsh::model::mesh::generate(dimension);
  std::string error;
  gmsh::logger::getLastError(error);
  if (!error.empty())
    throw std::runtime_error(error);
}
} // namespace

std::size_t memory_limit_of_gmsh()
{
  constexpr std::size_t least = std::size_t(4) << 30;
  const long n_pages = ::sysconf(_SC_PHYS_PAGES), size = ::sysconf(_SC_PAGE_SIZE);
  if (n_pages <= 0 || size <= 0)
    return least;
  return std::max(least, static_cast<std::size_t>(n_pages) / 2 * static_cast<std::size_t>(size));
}

std::string mesh_in_own_process(const GmshTask &task)
{
  const TemporaryFolder folder;
  const std::string mesh_file = (folder.path / "mesh.msh").string();
  const std::string log = (folder.path / "log").string();
  ChildProcess::Program program;
  program.file = "/proc/self/exe";
  program.arguments = {"continua",    gmsh_process_argument,
                       task.geo_file, std::to_string(task.dimension),
                       mesh_file,     task.allows_commands ? "1" : "0"};
  program.environment = environment_without_launcher();
  program.screen = log;
  const int status = ChildProcess(program).wait(task.time_limit).status;
  const std::string said = last_lines(log);
  if (WIFSIGNALED(status))
    throw std::runtime_error("it was ended by the signal '" +
                             std::string(::strsignal(WTERMSIG(status))) + "' (it may take " +
                             std::to_string(memory_limit_of_gmsh() >> 20) + " MiB of memory)" +
                             (said.empty() ? "" : ": " + said));
  if (WEXITSTATUS(status) != 0)
    throw std::runtime_error(
        said.empty() ? "it ended with the status " + std::to_string(WEXITSTATUS(status)) : said);
  std::error_code no_access;
  if (!std::filesystem::exists(mesh_file, no_access))
    throw std::runtime_error("it ended before the mesh was made, as by 'Exit;' in the file");
  return read_input_file(mesh_file, "mesh");
}

bool is_gmsh_process(const int argc, const char *const *argv)
{
  return argc == n_arguments && argv[1] == gmsh_process_argument;
}

int run_gmsh_process(int, const char *const *argv)
{
  const std::string geo_file = argv[2], mesh_file = argv[4];
  const int dimension = std::atoi(argv[3]);
  const bool allows_commands = std::string(argv[5]) == "1";
  limit_this_process(memory_limit_of_gmsh());
  // Without the configuration files of the user, and on one thread: the same mesh each time.
  std::string error = error_of(
      []
      {
        gmsh::initialize(0, nullptr, false);
        gmsh::option::setNumber("General.Terminal", 0);
        gmsh::option::setNumber("General.NumThreads", 1);
      });
  if (error.empty())
  {
    // What is refused to a thread is refused for ever, and the mesh is still to be written.
    std::thread reader(
        [&]
        {
          error = error_of(
              [&]
              {
                if (!allows_commands)
                  refuse_programs_and_writing_to_this_thread();
                make_mesh(geo_file, dimension);
              });
        });
    reader.join();
  }
  if (error.empty())
    error = error_of(
        [&]
        {
          gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
          gmsh::option::setNumber("Mesh.Binary", 0);
          gmsh::option::setNumber("Mesh.SaveAll", 1);
          // Under another name first: a mesh that is there is whole.
          const std::string part = mesh_file + ".part.msh";
          gmsh::write(part);
          std::filesystem::rename(part, mesh_file);
        });
  if (!error.empty())
    std::cerr << error << std::endl;
  // What the file may have left to be done at the end of the program is not done.
  ::_exit(error.empty() ? 0 : 1);
}
} // namespace Continua
