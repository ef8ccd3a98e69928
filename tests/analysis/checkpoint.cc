// A checkpoint is complete or not there: kills between its writes, other cases, damage.

#include <continua/analysis/checkpoint.h>
#include <continua/base/input_error.h>

#include <deal.II/base/mpi.h>

#include "../check.h"

#include <filesystem>
#include <fstream>

using namespace Continua;
namespace fs = std::filesystem;

int main(int argc, char **argv)
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
  const Checkpoint checkpoint(MPI_COMM_WORLD, folder, "beam");
  const auto fill = [rank](const double value)
  {
    return [rank, value](ArchiveWriter &archive) {
      archive.add("values", std::vector<double>{value, 1. / 3., 10. + rank});
    };
  };
  const auto holds = [rank](const Checkpoint &from, const double value)
  {
    const bool mine =
        from.read().values("values") == std::vector<double>{value, 1. / 3., 10. + rank};
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

  check::throws<InputError>(
      "another case", [&] { Checkpoint(MPI_COMM_WORLD, folder, "tube").read(); },
      "other parameters");
  // As if written by seven ranks.
  if (rank == 0)
    fs::remove_all(folder + "-seven");
  MPI_Barrier(MPI_COMM_WORLD);
  const Checkpoint alone(MPI_COMM_SELF, folder + "-seven", "beam");
  if (rank == 0)
    alone.write(10, fill(1.), nullptr);
  MPI_Barrier(MPI_COMM_WORLD);
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    check::throws<InputError>(
        "number of ranks", [&] { Checkpoint(MPI_COMM_WORLD, folder + "-seven", "beam").read(); },
        "rank");
  else
    std::cout << "number of ranks: ok" << std::endl;

  MPI_Barrier(MPI_COMM_WORLD);
  {
    const std::string name = folder + "/30/rank-" + std::to_string(rank);
    std::fstream file(name, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(fs::file_size(name) - 20);
    file.put('x');
  }
  check::throws<RunError>(
      "damaged", [&] { checkpoint.read(); }, "rank-0.*|damaged|checksum");
}
