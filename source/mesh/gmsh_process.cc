#include <continua/base/input_file.h>
#include <continua/mesh/gmsh_process.h>
#include <continua/mesh/system_call_filter.h>

#include <fcntl.h>
#include <gmsh.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
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

/// The environment without what a launcher of MPI gives to its processes.
std::vector<char *> environment_without_launcher()
{
  std::vector<char *> kept;
  for (char **entry = environ; *entry != nullptr; ++entry)
  {
    const std::string text = *entry;
    const auto begins_with = [&text](const std::string &prefix)
    { return text.compare(0, prefix.size(), prefix) == 0; };
    bool is_of_launcher = false;
    for (const char *const prefix :
         {"OMPI_", "OPAL_", "ORTE_", "PRTE_", "PMIX_", "PMI_", "PMI2_", "MPI_", "MPIR_", "MPIEXEC_",
          "HYDRA_", "HYDI_", "I_MPI_", "MV2_", "SLURM_"})
      is_of_launcher = is_of_launcher || begins_with(prefix);
    if (!is_of_launcher)
      kept.push_back(*entry);
  }
  kept.push_back(nullptr);
  return kept;
}

/// Starts the process; its screen is the file `log`.
pid_t start_process(const std::vector<std::string> &arguments, const std::string &log)
{
  std::vector<char *> texts;
  for (const std::string &argument : arguments)
    texts.push_back(const_cast<char *>(argument.c_str()));
  texts.push_back(nullptr);
  const std::vector<char *> environment = environment_without_launcher();

  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  sigset_t no_signals;
  ::sigemptyset(&no_signals);
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&files, 1, log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  ::posix_spawn_file_actions_adddup2(&files, 1, 2);
  ::posix_spawnattr_init(&attributes);
  ::posix_spawnattr_setsigmask(&attributes, &no_signals);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t process = 0;
  const int error = ::posix_spawn(&process, "/proc/self/exe", &files, &attributes, texts.data(),
                                  environment.data());
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&files);
  if (error != 0)
    throw std::runtime_error(std::string("its process cannot be started: ") + std::strerror(error));
  return process;
}

/// Waits for the end of the process and returns its status as of waitpid(); kills it after
/// `time_limit` [s] and throws std::runtime_error.
int wait_for(const pid_t process, const double time_limit)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  std::chrono::milliseconds pause(1);
  while (true)
  {
    int status = 0;
    const pid_t ended = ::waitpid(process, &status, WNOHANG);
    if (ended == process)
      return status;
    if (ended < 0 && errno != EINTR)
      throw std::runtime_error(std::string("its process was lost: ") + std::strerror(errno));
    if (std::chrono::duration<double>(Clock::now() - start).count() > time_limit)
    {
      ::kill(process, SIGKILL);
      ::waitpid(process, &status, 0);
      std::ostringstream text;
      text << "it did not end within " << time_limit << " s";
      throw std::runtime_error(text.str());
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::milliseconds(50));
  }
}

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

// GCC says it by a macro, clang by a feature.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool has_address_sanitizer = true;
#elif defined(__has_feature)
constexpr bool has_address_sanitizer = __has_feature(address_sanitizer);
#else
constexpr bool has_address_sanitizer = false;
#endif

/// Limits what this process may take, and lets it end with the process that started it.
void limit_this_process()
{
  const rlimit limit = {memory_limit_of_gmsh(), memory_limit_of_gmsh()};
  const rlimit nothing = {0, 0};
  // The sanitizer of addresses reserves terabytes for its own use.
  if (!has_address_sanitizer)
    ::setrlimit(RLIMIT_AS, &limit);
  ::setrlimit(RLIMIT_FSIZE, &limit);
  ::setrlimit(RLIMIT_CORE, &nothing);
#if defined(__linux__)
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
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
  const int status = wait_for(
      start_process({"continua", gmsh_process_argument, task.geo_file,
                     std::to_string(task.dimension), mesh_file, task.allows_commands ? "1" : "0"},
                    log),
      task.time_limit);
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
  limit_this_process();
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
