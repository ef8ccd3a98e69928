#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/base/output_directory.h>

#include <deal.II/base/mpi.h>

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>

namespace Continua
{
namespace
{
namespace fs = std::filesystem;

/// What is wrong with the folder, and what the user can do.
struct Refusal
{
  std::string problem;
  std::string remedy;
};

/// A checkpoint that was finished: its files have lost the ending of the temporary ones.
bool has_checkpoint(const fs::path &directory)
{
  std::error_code error;
  for (const fs::directory_entry &entry : fs::directory_iterator(directory / "checkpoint", error))
    if (entry.path().extension() != ".new")
      return true;
  return false;
}

bool holds_run(const fs::path &directory)
{
  std::error_code error;
  return fs::exists(directory / "summary.json", error) ||
         fs::exists(directory / "parameters.prm", error) || has_checkpoint(directory);
}

/// The files and folders of a run that are there. Of fields/ only the files of the two kinds that a
/// run writes: a saved view of ParaView beside them is the user's.
std::vector<fs::path> written_by_a_run(const fs::path &directory)
{
  std::vector<fs::path> result;
  for (const char *const name :
       {"parameters.prm", "log.txt", "summary.json", "probes.csv", "power.csv", "refinement.csv",
        "fields.pvd", "citation.bib", "checkpoint", "input", "plots"})
    if (fs::exists(fs::symlink_status(directory / name)))
      result.push_back(directory / name);
  std::error_code error;
  for (const fs::directory_entry &entry : fs::directory_iterator(directory / "fields", error))
    if (entry.path().extension() == ".vtu" || entry.path().extension() == ".pvtu")
      result.push_back(entry.path());
  return result;
}

/// Whether `file` is `folder` or lies in it.
bool lies_in(const fs::path &file, const fs::path &folder)
{
  const fs::path resolved_file = fs::weakly_canonical(file);
  const fs::path resolved_folder = fs::weakly_canonical(folder);
  auto part = resolved_file.begin();
  for (const fs::path &name : resolved_folder)
  {
    if (part == resolved_file.end() || *part != name)
      return false;
    ++part;
  }
  return true;
}

Refusal remove_run(const fs::path &directory, const std::vector<std::string> &inputs)
{
  const std::vector<fs::path> paths = written_by_a_run(directory);
  for (const fs::path &path : paths)
    for (const std::string &input : inputs)
      if (lies_in(input, path))
        return {"--overwrite would remove '" + input + "', which this run reads",
                "Copy that file to another folder, or choose another folder with --output"};
  for (const fs::path &path : paths)
    fs::remove_all(path);
  return {};
}

/// On rank 0: everything the constructor promises. An empty problem: done.
Refusal prepare(const fs::path &directory,
                const OutputDirectory::Mode mode,
                const std::vector<std::string> &inputs)
{
  using Mode = OutputDirectory::Mode;
  const std::string another = "Choose another folder with --output";
  if (fs::exists(directory) && !fs::is_directory(directory))
    return {"this is a file, not a folder", another};
  if (mode == Mode::restart && !has_checkpoint(directory))
    return {"there is no checkpoint to restart from",
            "Name the folder of the run with --output, or start anew without --restart"};
  if (mode == Mode::fresh && holds_run(directory))
    return {"the folder holds a run",
            "Replace it with --overwrite, continue it with --restart, or choose another folder "
            "with --output"};

  fs::create_directories(directory);
  if (::access(directory.c_str(), W_OK | X_OK) != 0)
    return {std::string("the folder is not writable: ") + std::strerror(errno), another};
  if (mode == Mode::overwrite && holds_run(directory))
  {
    const Refusal refusal = remove_run(directory, inputs);
    if (!refusal.problem.empty())
      return refusal;
  }
  for (const char *const name : {"fields", "checkpoint", "input"})
    fs::create_directories(directory / name);
  return {};
}

/// Copies each file once.
void copy_to(const fs::path &folder, const std::vector<std::string> &files)
{
  std::set<fs::path> sources, names;
  for (const std::string &file : files)
  {
    if (!sources.insert(fs::weakly_canonical(file)).second)
      continue;
    const fs::path source(file);
    fs::path name = source.filename();
    for (unsigned int number = 2; !names.insert(name).second; ++number)
      name = source.stem().string() + "-" + std::to_string(number) + source.extension().string();
    // After a restart with the copies themselves as input there is nothing to copy.
    if (!fs::exists(folder / name) || !fs::equivalent(source, folder / name))
      fs::copy_file(source, folder / name, fs::copy_options::overwrite_existing);
  }
}
} // namespace

OutputDirectory::OutputDirectory(const std::string &path,
                                 const Mode mode,
                                 const MPI_Comm communicator,
                                 const std::vector<std::string> &inputs)
    : directory(path), communicator(communicator)
{
  while (directory.size() > 1 && directory.back() == '/')
    directory.pop_back();

  Refusal refusal;
  if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    try
    {
      refusal = prepare(directory, mode, inputs);
    }
    catch (const fs::filesystem_error &error)
    {
      refusal = {"the folder cannot be prepared: " + error.code().message() + " ('" +
                     error.path1().string() + "')",
                 "Choose another folder with --output"};
    }
  const auto all =
      broadcast(communicator, std::vector<std::string>{refusal.problem, refusal.remedy});
  if (!all[0].empty())
    throw InputError({directory, 0}, "", all[0], all[1]);
}

std::string OutputDirectory::file(const std::string &name) const
{
  return directory + "/" + name;
}

const std::string &OutputDirectory::path() const
{
  return directory;
}

void OutputDirectory::copy_inputs(const std::vector<std::string> &files) const
{
  std::string problem;
  if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    try
    {
      copy_to(file("input"), files);
    }
    catch (const fs::filesystem_error &error)
    {
      problem = "cannot copy '" + error.path1().string() + "' to '" + file("input") +
                "': " + error.code().message();
    }
  problem = broadcast(communicator, problem);
  if (!problem.empty())
    throw RunError(problem);
}
} // namespace Continua
