// A checkpoint is complete or not there: kills between its writes, other cases, damage.

#include <continua/analysis/checkpoint.h>
#include <continua/base/input_error.h>

#include <deal.II/base/mpi.h>

#include "../unit_test.h"

#include <filesystem>
#include <fstream>
#include <functional>

using namespace Continua;
namespace fs = std::filesystem;

UNIT_TEST(checkpoint)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  if (rank != 0)
    std::cout.setstate(std::ios::failbit);
  const std::string folder =
      "checkpoint_test_" + std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
  if (rank == 0)
    fs::remove_all(folder);
  MPI_Barrier(MPI_COMM_WORLD);
  const std::string identity = "Mesh/Cells=12\nModel=plane strain\ncontent of load.csv=01\n";
  const Checkpoint checkpoint(MPI_COMM_WORLD, folder, identity);
  const auto fill = [rank](const double value)
  {
    return [rank, value](ArchiveWriter &archive)
    {
      archive.add("value", value);
      archive.piece().add("values", std::vector<double>{value, 1. / 3., 10. + rank});
    };
  };
  const auto holds = [rank](const Checkpoint &from, const double value)
  {
    const ArchiveReader archive = from.read();
    const bool mine =
        archive.value("value") == value &&
        archive.piece(rank).values("values") == std::vector<double>{value, 1. / 3., 10. + rank};
    return dealii::Utilities::MPI::min(mine ? 1 : 0, MPI_COMM_WORLD) == 1;
  };

  check::throws<InputError>(
      "none", [&] { checkpoint.read(); }, "no complete checkpoint");
  checkpoint.write(10, fill(1.), nullptr);
  check::is_true("first: bit by bit, each rank its own", holds(checkpoint, 1.));
  check::is_true("first: no mesh", checkpoint.mesh_file().empty());
  checkpoint.write(20, fill(2.),
                   [rank](const std::string &name)
                   {
                     if (rank == 0)
                       std::ofstream(name) << "mesh\n";
                   });
  check::is_true("second", holds(checkpoint, 2.));
  check::equal("second: mesh", checkpoint.mesh_file(), folder + "/20/mesh");
  check::is_true("the first one is gone", !fs::exists(folder + "/10"));

  // Killed while the third is written: all its files may be there, but it is not named.
  if (rank == 0)
  {
    fs::copy(folder + "/20", folder + "/30", fs::copy_options::recursive);
    std::ofstream(folder + "/30/rank-0") << "half a fi";
  }
  MPI_Barrier(MPI_COMM_WORLD);
  check::is_true("killed before it is named: the old one", holds(checkpoint, 2.));
  // Killed within the writing of an archive: an exception stands for the kill.
  try
  {
    checkpoint.write(
        30, [](ArchiveWriter &) { throw std::runtime_error("killed"); }, nullptr);
  }
  catch (const std::runtime_error &)
  {
  }
  MPI_Barrier(MPI_COMM_WORLD);
  check::is_true("killed within the writing: the old one", holds(checkpoint, 2.));
  checkpoint.write(30, fill(3.), nullptr);
  check::is_true("written again over what was left", holds(checkpoint, 3.));

  const auto refused =
      [&folder](const std::string &name, const std::string &other, const std::string &pattern)
  {
    check::throws<InputError>(
        name, [&] { Checkpoint(MPI_COMM_WORLD, folder, other).read(); }, pattern);
  };
  refused("another value", "Mesh/Cells=24\nModel=plane strain\ncontent of load.csv=01\n",
          "Mesh/Cells is 12 there and 24 here");
  refused("another table", "Mesh/Cells=12\nModel=plane strain\ncontent of load.csv=02\n",
          "the content of load.csv is another");
  refused("an entry less", "Mesh/Cells=12\nModel=plane strain\n",
          "content of load.csv is 01 there and no entry of this case");
  refused("an entry more", "A=\n" + identity, "A is empty here and no entry there");

  // One rank goes on from what others wrote, and they from what it wrote.
  MPI_Barrier(MPI_COMM_WORLD);
  const Checkpoint alone(MPI_COMM_SELF, folder, identity);
  bool found = true;
  {
    const ArchiveReader archive = alone.read();
    for (unsigned int r = 0; r < archive.n_pieces(); ++r)
      found = found && archive.piece(r).values("values")[2] == 10. + r;
    found = found && archive.n_pieces() == dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  }
  check::is_true("another number of ranks", found);

  // Every file counts, whichever rank looks at it.
  const auto damaged = [&](const std::string &name, const std::string &file,
                           const std::string &pattern,
                           const std::function<void(const fs::path &)> &damage)
  {
    MPI_Barrier(MPI_COMM_WORLD);
    const fs::path path = folder + "/40/" + file;
    if (rank == 0)
    {
      fs::remove_all(folder + "/40.whole");
      fs::copy(folder + "/40", folder + "/40.whole");
      damage(path);
    }
    MPI_Barrier(MPI_COMM_WORLD);
    refused(name, identity, pattern);
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank == 0)
    {
      fs::remove_all(folder + "/40");
      fs::rename(folder + "/40.whole", folder + "/40");
    }
    MPI_Barrier(MPI_COMM_WORLD);
  };
  const auto flip_a_bit = [](const fs::path &path)
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(static_cast<std::streamoff>(fs::file_size(path)) - 20);
    const char old = static_cast<char>(file.get());
    file.seekp(static_cast<std::streamoff>(fs::file_size(path)) - 20);
    file.put(static_cast<char>(old ^ 4));
  };
  checkpoint.write(40, fill(4.),
                   [rank](const std::string &name)
                   {
                     if (rank == 0)
                       std::ofstream(name) << "the mesh of a run that has adapted\n";
                   });
  const std::string last =
      "rank-" + std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1);
  damaged("a bit of the state", "state", "'.*/40/state' is truncated or damaged", flip_a_bit);
  damaged("a bit of a piece", last, last + "' is truncated or damaged", flip_a_bit);
  damaged("a bit of the mesh", "mesh", "'.*/40/mesh' is truncated or damaged", flip_a_bit);
  const auto cut = [](const fs::path &path) { fs::resize_file(path, fs::file_size(path) - 9); };
  damaged("a piece cut short", last, "is truncated or damaged", cut);
  const auto remove = [](const fs::path &path) { fs::remove(path); };
  damaged("a piece is missing", last, "cannot read '.*/40/" + last + "': No such file", remove);
  damaged("the state is missing", "state", "cannot read '.*/40/state'", remove);
  damaged("the mesh is missing", "mesh", "cannot read '.*/40/mesh'", remove);
  damaged("a piece of another state", last, "is not of this checkpoint",
          [&](const fs::path &path)
          {
            ArchiveWriter other;
            other.write(path);
          });
  check::is_true("all put back", holds(checkpoint, 4.));

  // A folder in the place of a file stands for a disk that refuses.
  bool kept = false;
  try
  {
    checkpoint.write(50, fill(5.),
                     [&](const std::string &name)
                     {
                       if (rank == 0)
                         fs::create_directories(fs::path(name).parent_path() / "state.new");
                     });
  }
  catch (const RunError &error)
  {
    kept = std::string(error.what()).find("that of step 40 is kept") != std::string::npos;
  }
  MPI_Barrier(MPI_COMM_WORLD);
  check::is_true("the disk refuses: all ranks are told", kept);
  check::is_true("the disk refuses: the old one", holds(checkpoint, 4.));
  check::is_true("the disk refuses: nothing is left", !fs::exists(folder + "/50"));
}
