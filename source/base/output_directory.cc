#include <continua/base/atomic_file.h>
#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/base/output_directory.h>
#include <continua/base/output_files.h>

#include <deal.II/base/mpi.h>

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

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

bool holds_run(const fs::path &directory)
{
  std::error_code error;
  return fs::exists(directory / "summary.json", error) ||
         fs::exists(directory / "parameters.prm", error) ||
         OutputDirectory::has_checkpoint(directory.string());
}

const std::string list_of_others = "other-files.txt";

/// The names in a folder that only its run knew before; those of folders end with a slash.
std::vector<std::string> names_of_case(const fs::path &directory)
{
  std::vector<std::string> names;
  std::ifstream stream(directory / list_of_others);
  for (std::string name; std::getline(stream, name);)
  {
    const std::string base = name.substr(0, name.find('/'));
    // Whatever the file says: nothing outside of the folder is a run's.
    if (!base.empty() && base != "." && base != ".." && (name == base || name == base + "/"))
      names.push_back(name);
  }
  return names;
}

/// What an overwrite removes.
struct RunFiles
{
  std::vector<fs::path> paths;
  /// Folders of runs of their own, which are removed if nothing of the user is left in them.
  std::vector<fs::path> folders;
  std::vector<std::unique_ptr<FolderLock>> locks; ///< of these
  std::string holder;                             ///< who works in one of them
};

/// Adds the files and folders of a run that are there. Of fields/ only the files of the two kinds
/// that a run writes: a saved view of ParaView beside them is the user's. The list of the others
/// comes last: an overwrite that is killed leaves it.
void add_run(const fs::path &directory, RunFiles &files)
{
  const auto add = [&files](const fs::path &path)
  {
    if (fs::exists(fs::symlink_status(path)))
      files.paths.push_back(path);
  };
  for (const std::string &name : output_files())
    if (name != "fields" && name != list_of_others)
      add(directory / name);
  std::error_code error;
  for (const fs::directory_entry &entry : fs::directory_iterator(directory / "fields", error))
    if (entry.path().extension() == ".vtu" || entry.path().extension() == ".pvtu")
      add(entry.path());
  for (const std::string &name : names_of_case(directory))
    if (name.back() != '/')
      add(directory / name);
    else if (const fs::path folder = directory / name.substr(0, name.size() - 1);
             fs::is_directory(fs::symlink_status(folder)))
    {
      files.locks.push_back(std::make_unique<FolderLock>(folder.string()));
      if (!files.locks.back()->holder().empty())
        files.holder = files.locks.back()->holder();
      add_run(folder, files);
      files.folders.insert(files.folders.end(), {folder / "fields", folder});
    }
  add(directory / list_of_others);
}

Refusal refusal_of_holder(const std::string &holder)
{
  return {"another run works in this folder: " + holder,
          "Wait until it has ended, or choose another folder with --output"};
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
  RunFiles files;
  add_run(directory, files);
  if (!files.holder.empty())
    return refusal_of_holder(files.holder);
  for (const fs::path &path : files.paths)
    for (const std::string &input : inputs)
      if (lies_in(input, path))
        return {"--overwrite would remove '" + input + "', which this run reads",
                "Copy that file to another folder, or choose another folder with --output"};
  for (const fs::path &path : files.paths)
    fs::remove_all(path);
  files.locks.clear();
  std::error_code error;
  for (const fs::path &folder : files.folders)
    fs::remove(folder, error); // refused where something is left in it
  return {};
}

/// On rank 0: everything the constructor promises. An empty problem: done.
Refusal prepare(const fs::path &directory,
                const OutputDirectory::Mode mode,
                const std::vector<std::string> &inputs,
                std::unique_ptr<FolderLock> &lock)
{
  using Mode = OutputDirectory::Mode;
  const std::string another = "Choose another folder with --output";
  if (fs::exists(directory) && !fs::is_directory(directory))
    return {"this is a file, not a folder", another};
  const Refusal no_checkpoint = {
      "there is no checkpoint to restart from",
      "Name the folder of the run with --output, or start anew without --restart"};
  if (mode == Mode::restart && !fs::exists(directory))
    return no_checkpoint;
  fs::create_directories(directory);
  // Before anything is looked at: another run may be changing it.
  std::string problem_of_lock;
  try
  {
    lock = std::make_unique<FolderLock>(directory.string());
    if (!lock->holder().empty())
      return refusal_of_holder(lock->holder());
  }
  catch (const RunError &error)
  {
    problem_of_lock = error.what();
  }
  if (mode == Mode::restart && !OutputDirectory::has_checkpoint(directory.string()))
    return no_checkpoint;
  if (mode == Mode::fresh && holds_run(directory))
    return {"the folder holds a run",
            "Replace it with --overwrite, continue it with --restart, or choose another folder "
            "with --output"};
  if (::access(directory.c_str(), W_OK | X_OK) != 0)
    return {std::string("the folder is not writable: ") + std::strerror(errno), another};
  if (!problem_of_lock.empty())
    return {"the folder cannot be prepared: " + problem_of_lock, another};
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

/// The names of the copies: of files that are one file the same, of other files of one name each
/// with a number of its own.
std::vector<std::string> copied_names(const std::vector<std::string> &files)
{
  std::map<fs::path, std::string> name_of_source;
  std::set<fs::path> taken;
  std::vector<std::string> names;
  for (const std::string &file : files)
  {
    const fs::path source(file);
    std::string &name = name_of_source[fs::weakly_canonical(file)];
    if (name.empty())
    {
      name = source.filename().string();
      for (unsigned int number = 2; !taken.insert(name).second; ++number)
        name = source.stem().string() + "-" + std::to_string(number) + source.extension().string();
    }
    names.push_back(name);
  }
  return names;
}

/// Copies each file once.
void copy_to(const fs::path &folder, const std::vector<std::string> &files)
{
  const std::vector<std::string> names = copied_names(files);
  std::set<std::string> done;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const fs::path source(files[i]), copy = folder / names[i];
    // After a restart with the copies themselves as input there is nothing to copy.
    if (done.insert(names[i]).second && (!fs::exists(copy) || !fs::equivalent(source, copy)))
      fs::copy_file(source, copy, fs::copy_options::overwrite_existing);
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
      refusal = prepare(directory, mode, inputs, lock);
      if (lock)
        text_of_warning = lock->warning();
    }
    catch (const fs::filesystem_error &error)
    {
      refusal = {"the folder cannot be prepared: " + error.code().message() + " ('" +
                     error.path1().string() + "')",
                 "Choose another folder with --output"};
    }
    catch (const RunError &error)
    {
      refusal = {std::string("the folder cannot be prepared: ") + error.what(),
                 "Choose another folder with --output"};
    }
  const auto all = broadcast(
      communicator, std::vector<std::string>{refusal.problem, refusal.remedy, text_of_warning});
  if (!all[0].empty())
    throw InputError({directory, 0}, "", all[0], all[1]);
  text_of_warning = all[2];
}

bool OutputDirectory::has_checkpoint(const std::string &path)
{
  std::error_code error;
  for (const fs::directory_entry &entry :
       fs::directory_iterator(fs::path(path) / "checkpoint", error))
    if (entry.path().extension() != ".new")
      return true;
  return false;
}

std::string OutputDirectory::file(const std::string &name) const
{
  return output_file(directory, name);
}

std::string OutputDirectory::file_of_case(const std::string &name) const
{
  const std::string list = file(list_of_others);
  std::ostringstream text;
  if (std::ifstream before(list); before && before.peek() != std::ifstream::traits_type::eof())
    text << before.rdbuf();
  if (("\n" + text.str()).find("\n" + name + "\n") == std::string::npos)
    write_file_atomically(list, text.str() + name + "\n");
  return directory + "/" + name;
}

const std::string &OutputDirectory::path() const
{
  return directory;
}

std::map<std::string, std::string>
OutputDirectory::names_of_copies(const std::vector<std::string> &files)
{
  const std::vector<std::string> names = copied_names(files);
  std::map<std::string, std::string> result;
  for (std::size_t i = 0; i < files.size(); ++i)
    result[fs::absolute(files[i]).lexically_normal().string()] = "input/" + names[i];
  return result;
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
