#include <continua/analysis/checkpoint.h>

#include <continua/base/atomic_file.h>
#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/base/version.h>
#include <continua/postprocess/writing_rank.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

namespace Continua
{
using namespace dealii;

namespace
{
namespace fs = std::filesystem;

/// What goes wrong in `function` on this rank; empty if nothing does.
std::string problem_in(const std::function<void()> &function)
{
  try
  {
    function();
  }
  catch (const std::exception &error)
  {
    return error.what();
  }
  return "";
}

/// The problem of the first rank that has one, on all ranks.
std::string first_problem(const MPI_Comm communicator, const std::string &problem)
{
  if (Utilities::MPI::max(problem.empty() ? 0 : 1, communicator) == 0)
    return "";
  for (const std::string &one : all_gather(communicator, problem))
    if (!one.empty())
      return one;
  return "";
}

bool is_step(const std::string &name)
{
  return !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
}

/// What `checkpoint/current` says; empty if there is no such file. Throws RunError.
std::string read_current(const std::string &folder)
{
  const std::string file = folder + "/current";
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream && (errno == ENOENT || errno == ENOTDIR))
    return "";
  std::string name, more;
  if (stream)
    std::getline(stream, name);
  if (!stream || stream.bad())
    throw RunError("cannot read '" + file + "'" +
                   (errno != 0 ? std::string(": ") + std::strerror(errno) : std::string()));
  // Nothing but a step: a path would lead out of the folder.
  if (!is_step(name) || std::getline(stream, more))
    throw RunError("'" + file + "' does not name the step of a checkpoint");
  return name;
}

/// What a table has too much or too little to be continued; empty: nothing.
std::string
problem_of_table(const std::string &file, const unsigned long length, const unsigned long checksum)
{
  if (!fs::exists(file))
    return "'" + file + "' is missing, which the restart continues";
  const Checksum there = Checksum::of_file(file, length);
  if (there.length() < length)
    return "'" + file + "' has " + std::to_string(there.length()) + " bytes; it had " +
           std::to_string(length) + " when the checkpoint was written";
  if (there.value() != checksum)
    return "'" + file + "' has changed: its first " + std::to_string(length) +
           " bytes are not those that stood there when the checkpoint was written";
  return "";
}

void add_tables(ArchiveWriter &archive, const std::vector<WrittenTable> &tables)
{
  std::string names;
  std::vector<unsigned long> numbers;
  for (const WrittenTable &table : tables)
  {
    names += table.name + "\n";
    for (const Checksum *part : {&table.all, &table.without_last_row})
      numbers.insert(numbers.end(), {part->length(), part->value()});
  }
  archive.add("tables", names);
  archive.add("tables: lengths and checksums", numbers);
}

/// The entries of ParameterFile::identity_text.
std::map<std::string, std::string> entries_of(const std::string &identity)
{
  std::map<std::string, std::string> entries;
  std::istringstream lines(identity);
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t equals = line.find('=');
    entries[line.substr(0, equals)] =
        equals == std::string::npos ? std::string() : line.substr(equals + 1);
  }
  return entries;
}

/// The first entry that two cases do not have in common, in words.
std::string first_difference(const std::string &there, const std::string &here)
{
  const std::map<std::string, std::string> old = entries_of(there), present = entries_of(here);
  const auto text = [](const std::string &value) { return value.empty() ? "empty" : value; };
  for (const auto &[path, value] : old)
  {
    const auto found = present.find(path);
    if (found == present.end())
      return path + " is " + text(value) + " there and no entry of this case";
    if (found->second != value)
      return path.compare(0, 11, "content of ") == 0
                 ? "the " + path + " is another"
                 : path + " is " + text(value) + " there and " + text(found->second) + " here";
  }
  for (const auto &[path, value] : present)
    if (old.count(path) == 0)
      return path + " is " + text(value) + " here and no entry there";
  return "the order of its entries is another";
}
} // namespace

Checkpoint::Checkpoint(const MPI_Comm communicator,
                       const std::string &folder,
                       const std::string &identity)
    : communicator(communicator), folder(folder), identity(identity)
{
}

Checkpoint::Checkpoint(const MPI_Comm communicator,
                       const OutputDirectory &directory,
                       const ParameterFile &file)
    : Checkpoint(communicator,
                 directory.file("checkpoint"),
                 file.identity_text({"Title", "Time/End time", "Time/Velocity limit",
                                     "Mesh/Memory limit", "Linear solver", "Output", "Expected",
                                     "Comparison", "Refinement study", "Sweep",
                                     "Periodic state/Tolerance", "Periodic state/Stop"}))
{
}

std::string Checkpoint::archive_file(const std::string &step) const
{
  return folder + "/" + step + "/state";
}

std::string Checkpoint::piece_file(const std::string &step, const unsigned int rank) const
{
  return folder + "/" + step + "/rank-" + std::to_string(rank);
}

std::string Checkpoint::current() const
{
  std::string step;
  on_writing_rank(communicator, [&]() { step = read_current(folder); });
  return broadcast(communicator, step);
}

void Checkpoint::remove_all_but(const std::string &step) const
{
  std::error_code error;
  for (const fs::directory_entry &entry : fs::directory_iterator(folder, error))
    if (is_step(entry.path().filename().string()) && entry.path().filename() != step)
      fs::remove_all(entry.path());
}

std::string Checkpoint::write(const unsigned int step,
                              const std::function<void(ArchiveWriter &)> &fill,
                              const std::vector<WrittenTable> &tables) const
{
  const std::string name = std::to_string(step), path = folder + "/" + name;
  const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
  std::string before;
  const std::string unknown = problem_in([&]() { before = current(); });
  if (!unknown.empty())
    throw RunError("the checkpoint of step " + name + " cannot be written: " + unknown);
  // A state saved twice at the same step is the same state.
  if (before == name)
    return "";
  const auto stop_at = [&](const std::string &problem)
  {
    const std::string first = first_problem(communicator, problem);
    if (first.empty())
      return;
    // Never the state that is named, or may be.
    std::string named = name;
    if (rank == 0 && problem_in([&]() { named = read_current(folder); }).empty() && named != name)
    {
      std::error_code error;
      fs::remove_all(path, error);
    }
    throw RunError(
        "the checkpoint of step " + name + " cannot be written: " + first +
        (before.empty() ? "; there is no earlier one" : "; that of step " + before + " is kept"));
  };

  stop_at(problem_in(
      [&]()
      {
        if (rank != 0)
          return;
        fs::create_directories(folder);
        remove_all_but(before);
        fs::create_directory(path);
      }));
  ArchiveWriter archive;
  fill(archive);
  unsigned long checksum = 0;
  stop_at(problem_in([&]() { checksum = archive.piece().write(piece_file(name, rank)); }));
  const std::vector<unsigned long> checksums = all_gather(communicator, checksum);
  stop_at(problem_in(
      [&]()
      {
        if (rank != 0)
          return;
        archive.add("identity", identity);
        archive.add("version", version());
        archive.add("checksums of the pieces", checksums);
        add_tables(archive, tables);
        archive.write(archive_file(name));
        flush_to_disk(folder);
      }));
  stop_at(problem_in(
      [&]()
      {
        if (rank != 0)
          return;
        try
        {
          replace_file(folder + "/current", name + "\n");
        }
        catch (const RunError &)
        {
          // A network may report the failure of a renaming that took place.
          if (read_current(folder) != name)
            throw;
        }
      }));
  // From here on the new one stands, whatever happens. The old one stays until the disk has the
  // name, too.
  const std::string not_flushed = problem_in(
      [&]()
      {
        if (rank != 0)
          return;
        flush_to_disk(folder);
        problem_in([&]() { remove_all_but(name); });
      });
  const std::string first = first_problem(communicator, not_flushed);
  return first.empty() ? ""
                       : "the checkpoint of step " + name +
                             " stands, but a power failure may "
                             "bring the one before back: " +
                             first;
}

ArchiveReader Checkpoint::read() const
{
  const Origin origin{folder, 0};
  std::string step;
  const std::string problem = problem_in([&]() { step = current(); });
  if (!problem.empty())
    throw InputError(origin, "--restart", "the checkpoint cannot be read: " + problem,
                     "Put the file back from a copy, or run anew with --overwrite");
  if (step.empty())
    throw InputError(origin, "--restart", "there is no complete checkpoint",
                     "Run anew with --overwrite");
  const std::string remedy = "Put it back from a copy, or run anew with --overwrite";
  const auto stop_at = [&](const std::string &problem)
  {
    const std::string first = first_problem(communicator, problem);
    if (!first.empty())
      throw InputError(origin, "--restart", "the checkpoint cannot be read: " + first, remedy);
  };
  std::unique_ptr<ArchiveReader> archive;
  stop_at(problem_in([&]() { archive = std::make_unique<ArchiveReader>(archive_file(step)); }));
  stop_at(problem_in(
      [&]()
      {
        archive->text("version");
        archive->text("identity");
      }));
  check_case(*archive);
  stop_at(problem_in([&]() { check_files(*archive, step); }));
  std::vector<std::string> pieces;
  for (unsigned int i = 0; i < archive->integers("checksums of the pieces").size(); ++i)
    pieces.push_back(piece_file(step, i));
  archive->set_pieces(pieces);
  return std::move(*archive);
}

void Checkpoint::check_case(const ArchiveReader &archive) const
{
  const Origin origin{folder, 0};
  if (archive.text("version") != version())
    throw InputError(origin, "--restart",
                     "the checkpoint was written by version " + archive.text("version") +
                         ", this is " + version(),
                     "Use that version, or run anew with --overwrite");
  if (archive.text("identity") != identity)
    throw InputError(
        origin, "--restart",
        "the checkpoint belongs to another case: " +
            first_difference(archive.text("identity"), identity),
        "Restore the case (only Title, Time/End time, Time/Velocity limit, "
        "Mesh/Memory limit, Linear "
        "solver, Output, Expected, Comparison, Refinement study and Sweep may change), "
        "or run anew with --overwrite");
}

void Checkpoint::check_files(const ArchiveReader &archive, const std::string &step) const
{
  const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
  const std::vector<unsigned long> pieces = archive.integers("checksums of the pieces");
  for (unsigned int i = rank; i < pieces.size(); i += Utilities::MPI::n_mpi_processes(communicator))
    if (ArchiveReader(piece_file(step, i)).checksum() != pieces[i])
      throw RunError("'" + piece_file(step, i) + "' is not of this checkpoint");
}

void Checkpoint::check_tables(
    const ArchiveReader &archive,
    const std::string &output,
    const std::function<bool(const std::string &table)> &keeps_last_row) const
{
  const std::vector<unsigned long> numbers = archive.integers("tables: lengths and checksums");
  std::istringstream names(archive.text("tables"));
  std::vector<std::string> problems;
  std::size_t i = 0;
  for (std::string name; std::getline(names, name); i += 4)
  {
    const std::size_t part = i + (keeps_last_row(name) ? 0 : 2);
    problems.push_back(problem_in(
        [&]()
        {
          if (!is_writing_rank(communicator))
            return;
          const std::string problem = problem_of_table(std::string(output).append("/").append(name),
                                                       numbers.at(part), numbers.at(part + 1));
          if (!problem.empty())
            throw RunError(problem);
        }));
  }
  for (const std::string &problem : problems)
    if (const std::string first = first_problem(communicator, problem); !first.empty())
      throw InputError({folder, 0}, "--restart", first,
                       "Put the file back from a copy, or run anew with --overwrite");
}

void Checkpoint::cut_tables(
    const ArchiveReader &archive,
    const std::string &output,
    const std::function<bool(const std::string &table)> &keeps_last_row) const
{
  const std::vector<unsigned long> numbers = archive.integers("tables: lengths and checksums");
  std::istringstream names(archive.text("tables"));
  std::size_t i = 0;
  for (std::string name; std::getline(names, name); i += 4)
  {
    // The log keeps what it says.
    if (fs::path(name).extension() != ".csv")
      continue;
    const std::uintmax_t length = numbers.at(i + (keeps_last_row(name) ? 0 : 2));
    on_writing_rank(communicator,
                    [&]()
                    {
                      const fs::path file = fs::path(output) / name;
                      std::error_code error;
                      if (fs::file_size(file, error) > length && !error)
                        fs::resize_file(file, length, error);
                      if (error)
                        throw RunError("cannot cut '" + file.string() + "': " + error.message());
                    });
  }
}
} // namespace Continua
