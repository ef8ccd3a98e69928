// A checkpoint is complete or not there: kills between its writes, other cases, damage.

#include <continua/analysis/checkpoint.h>
#include <continua/base/input_error.h>

#include <deal.II/base/mpi.h>

#include "../unit_test.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>

namespace test_of_checkpoint
{
using namespace Continua;
namespace fs = std::filesystem;

namespace
{
/// The flush of a folder that fails, counted from 1 once it is set; 0: none.
int failing_flush_of_folder = 0;
bool renaming_fails = false, renaming_pretends = false;
} // namespace

// In place of the system's.
extern "C" int fsync(const int descriptor)
{
  struct stat status;
  if (failing_flush_of_folder > 0 && fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode) &&
      --failing_flush_of_folder == 0)
  {
    errno = EIO;
    return -1;
  }
  return static_cast<int>(syscall(SYS_fsync, descriptor));
}

extern "C" int rename(const char *const old_name, const char *const new_name) noexcept
{
  const bool is_current = std::string(new_name).find("/current") != std::string::npos;
  if (!(renaming_fails && is_current) || renaming_pretends)
    if (syscall(SYS_renameat2, AT_FDCWD, old_name, AT_FDCWD, new_name, 0) != 0)
      return -1;
  if (renaming_fails && is_current)
  {
    errno = EIO;
    return -1;
  }
  return 0;
}

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
  checkpoint.write(10, fill(1.));
  check::is_true("first: bit by bit, each rank its own", holds(checkpoint, 1.));
  checkpoint.write(20, fill(2.));
  check::is_true("second", holds(checkpoint, 2.));
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
    checkpoint.write(30, [](ArchiveWriter &) { throw std::runtime_error("killed"); });
  }
  catch (const std::runtime_error &)
  {
  }
  MPI_Barrier(MPI_COMM_WORLD);
  check::is_true("killed within the writing: the old one", holds(checkpoint, 2.));
  checkpoint.write(30, fill(3.));
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
  checkpoint.write(40, fill(4.));
  const std::string last =
      "rank-" + std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) - 1);
  damaged("a bit of the state", "state", "'.*/40/state' is truncated or damaged", flip_a_bit);
  damaged("a bit of a piece", last, last + "' is truncated or damaged", flip_a_bit);
  const auto cut = [](const fs::path &path) { fs::resize_file(path, fs::file_size(path) - 9); };
  damaged("a piece cut short", last, "is truncated or damaged", cut);
  const auto remove = [](const fs::path &path) { fs::remove(path); };
  damaged("a piece is missing", last, "cannot read '.*/40/" + last + "': No such file", remove);
  damaged("the state is missing", "state", "cannot read '.*/40/state'", remove);
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
    checkpoint.write(50,
                     [&](ArchiveWriter &archive)
                     {
                       fill(5.)(archive);
                       if (rank == 0)
                         fs::create_directories(folder + "/50/state.new");
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

  // Each flush of a folder fails once: the pieces' (one on each rank), the state's, that of
  // checkpoint/ before the renaming, and that after it.
  const auto write_failing = [&](const unsigned int step, const double value, std::string &warning)
  {
    try
    {
      warning = checkpoint.write(step, fill(value));
    }
    catch (const RunError &)
    {
      MPI_Barrier(MPI_COMM_WORLD);
      return false;
    }
    MPI_Barrier(MPI_COMM_WORLD);
    return true;
  };
  std::string warning;
  for (int flush = 1; flush <= 3; ++flush)
  {
    failing_flush_of_folder = rank == 0 ? flush : 0;
    const std::string name = "flush " + std::to_string(flush) + " of a folder fails";
    check::is_true(name, !write_failing(50, 5., warning));
    check::is_true(name + ": the old one", holds(checkpoint, 4.) && !fs::exists(folder + "/50"));
  }
  failing_flush_of_folder = rank == 0 ? 4 : 0;
  check::is_true("the flush after the renaming fails: a warning on all ranks",
                 write_failing(50, 5., warning) &&
                     check::matches(warning, "step 50 stands.*Input/output error"));
  check::is_true("the new one stands, and the old one, too",
                 holds(checkpoint, 5.) && fs::exists(folder + "/40/state"));
  renaming_fails = true;
  check::is_true("the renaming fails", !write_failing(60, 6., warning));
  check::is_true("the renaming fails: the old one",
                 holds(checkpoint, 5.) && !fs::exists(folder + "/60"));
  renaming_pretends = true;
  check::is_true("a renaming that took place", write_failing(60, 6., warning) && warning.empty());
  check::is_true("a renaming that took place: the new one",
                 holds(checkpoint, 6.) && !fs::exists(folder + "/50"));
  renaming_fails = false;
  check::is_true("no warning", write_failing(70, 7., warning) && warning.empty());

  // `current` names a step and nothing else.
  const auto with_current = [&](const std::string &text, const std::string &pattern)
  {
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank == 0)
    {
      fs::create_directories("checkpoint_test_elsewhere");
      fs::copy(folder + "/70", "checkpoint_test_elsewhere", fs::copy_options::overwrite_existing);
      std::ofstream(folder + "/current") << text;
    }
    MPI_Barrier(MPI_COMM_WORLD);
    refused("current is '" + text.substr(0, text.find('\n')) + "'", identity, pattern);
    check::is_true("and no state is written over it or removed",
                   !write_failing(80, 8., warning) && fs::exists(folder + "/70/state"));
  };
  for (const std::string text :
       {"../checkpoint_test_elsewhere\n", "/tmp\n", "70/../70\n", "70 \n", "\n", "70\n60\n"})
    with_current(text, "current' does not name the step of a checkpoint");
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank == 0)
  {
    fs::remove_all("checkpoint_test_elsewhere");
    std::ofstream(folder + "/current") << "70\n";
  }
  MPI_Barrier(MPI_COMM_WORLD);
  check::is_true("put back", holds(checkpoint, 7.));

  // Tables that a restart continues.
  const std::string output = folder + "/output";
  const std::string text = "time [s],a\n1,2\n2,3\n", last_row = "2,3\n";
  const auto table_is = [&](const std::string &there)
  {
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank == 0)
    {
      fs::create_directories(output);
      std::ofstream(output + "/power.csv", std::ios::binary) << there;
    }
    MPI_Barrier(MPI_COMM_WORLD);
  };
  WrittenTable table;
  table.name = "power.csv";
  table.all.add(text);
  table.without_last_row.add(text.substr(0, text.size() - last_row.size()));
  checkpoint.write(90, fill(9.), {table});
  const auto check_table = [&](const bool keeps_last_row)
  {
    checkpoint.check_tables(checkpoint.read(), output,
                            [keeps_last_row](const std::string &name)
                            { return name != "power.csv" || keeps_last_row; });
  };
  const auto refuses =
      [&](const std::string &name, const std::string &pattern, const bool keeps_last_row = true)
  {
    check::throws<InputError>(
        name, [&]() { check_table(keeps_last_row); }, pattern);
  };
  table_is(text);
  check_table(true);
  table_is(text + "3,4\n5");
  check_table(true);
  table_is("time [s],a\n1,2\n3,5\n");
  check_table(false);
  refuses("the last row is another", "power.csv' has changed: its first 19 bytes");
  table_is("time [s],a\n1,3\n2,3\n");
  refuses("a row is another", "power.csv' has changed: its first 15 bytes", false);
  table_is(text.substr(0, 15));
  check_table(false);
  refuses("shorter by a row", "power.csv' has 15 bytes; it had 19 .*Put the file back");
  table_is("");
  refuses("empty", "power.csv' has 0 bytes; it had 15", false);
  MPI_Barrier(MPI_COMM_WORLD);
  if (rank == 0)
    fs::remove(output + "/power.csv");
  MPI_Barrier(MPI_COMM_WORLD);
  refuses("missing", "output/power.csv' is missing, which the restart continues");
}
} // namespace test_of_checkpoint
