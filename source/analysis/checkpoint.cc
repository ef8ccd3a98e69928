#include <continua/analysis/checkpoint.h>

#include <continua/base/atomic_file.h>
#include <continua/base/input_error.h>
#include <continua/base/version.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>

namespace Continua
{
using namespace dealii;

Checkpoint::Checkpoint(const MPI_Comm communicator,
                       const std::string &folder,
                       const std::string &identity)
    : communicator(communicator), folder(folder), identity(identity)
{
}

std::string Checkpoint::archive_file(const std::string &step) const
{
  return folder + "/" + step + "/rank-" +
         std::to_string(Utilities::MPI::this_mpi_process(communicator));
}

std::string Checkpoint::current() const
{
  std::ifstream file(folder + "/current");
  std::string step;
  file >> step;
  return step;
}

void Checkpoint::write(const unsigned int step,
                       const std::function<void(ArchiveWriter &)> &fill,
                       const std::function<void(const std::string &)> &save_mesh) const
{
  const std::string name = std::to_string(step);
  const bool is_writer = Utilities::MPI::this_mpi_process(communicator) == 0;
  // A state saved twice at the same step is the same state.
  if (current() == name)
    return;
  if (is_writer)
    std::filesystem::create_directories(folder + "/" + name);
  MPI_Barrier(communicator);
  ArchiveWriter archive;
  archive.add("identity", identity);
  archive.add("version", version());
  archive.add("number of ranks",
              static_cast<unsigned long>(Utilities::MPI::n_mpi_processes(communicator)));
  fill(archive);
  archive.write(archive_file(name));
  if (save_mesh)
    save_mesh(folder + "/" + name + "/mesh");
  MPI_Barrier(communicator);
  if (is_writer)
  {
    const std::string before = current();
    write_file_atomically(folder + "/current", name + "\n");
    if (!before.empty())
      std::filesystem::remove_all(folder + "/" + before);
  }
  MPI_Barrier(communicator);
}

ArchiveReader Checkpoint::read() const
{
  const std::string step = current();
  const Origin origin{folder, 0};
  if (step.empty())
    throw InputError(origin, "--restart", "there is no complete checkpoint",
                     "Run without --restart");
  if (!std::filesystem::exists(archive_file(step)))
    throw InputError(origin, "--restart",
                     "the checkpoint was written by fewer ranks than the run has now",
                     "Restart with as many ranks as before");
  ArchiveReader archive(archive_file(step));
  if (archive.text("version") != version())
    throw InputError(origin, "--restart",
                     "the checkpoint was written by version " + archive.text("version") +
                         ", this is " + version(),
                     "Use that version, or run anew with --overwrite");
  if (archive.integer("number of ranks") != Utilities::MPI::n_mpi_processes(communicator))
    throw InputError(origin, "--restart",
                     "the checkpoint was written by " +
                         std::to_string(archive.integer("number of ranks")) + " ranks",
                     "Restart with as many ranks as before");
  if (archive.text("identity") != identity)
    throw InputError(origin, "--restart", "the checkpoint belongs to other parameters than these",
                     "Restore them (only Title, Time/End time, Output and Expected may change), or "
                     "run anew with --overwrite");
  return archive;
}

std::string Checkpoint::mesh_file() const
{
  const std::string file = folder + "/" + current() + "/mesh";
  return std::filesystem::exists(file) ? file : "";
}
} // namespace Continua
