// The folder of a run: what is created, refused, removed and left alone.

#include <continua/base/input_error.h>
#include <continua/base/output_directory.h>

#include "../unit_test.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace test_of_output_directory
{
using namespace Continua;
namespace fs = std::filesystem;
using Mode = OutputDirectory::Mode;

namespace
{
// Every rank has its own folder, so that the test is the same on any number of ranks.
std::string base;

void write(const std::string &file, const std::string &text = "x")
{
  fs::create_directories(fs::path(base + file).parent_path());
  std::ofstream(base + file) << text;
}

bool there(const std::string &file)
{
  return fs::exists(base + file);
}

std::string content(const std::string &file)
{
  std::ostringstream text;
  text << std::ifstream(base + file).rdbuf();
  return text.str();
}

void refused(const std::string &name,
             const std::string &path,
             const Mode mode,
             const std::string &pattern,
             const std::vector<std::string> &inputs = {})
{
  check::throws<InputError>(
      name, [&]() { OutputDirectory directory(path, mode, MPI_COMM_SELF, inputs); }, pattern);
}
} // namespace

UNIT_TEST(output_directory)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  base = "output-directory-test-" + std::to_string(rank) + "/";
  fs::remove_all(base);
  fs::create_directories(base);
  if (rank != 0)
    std::cout.setstate(std::ios::failbit);

  {
    const OutputDirectory fresh(base + "a/b//", Mode::fresh, MPI_COMM_SELF);
    check::is_true("folders", there("a/b/fields") && there("a/b/checkpoint") && there("a/b/input"));
    check::equal("path", fresh.path(), base + "a/b");
    check::equal("file", fresh.file("log.txt"), base + "a/b/log.txt");
    check::throws<dealii::ExceptionBase>(
        "a file that no overwrite would remove", [&fresh]() { fresh.file("new-table.csv"); },
        "'new-table.csv', which is missing");
    // Whoever comes while it lives is refused and changes nothing.
    write("a/b/probes.csv", "1");
    const std::string holder = "another run works in this folder: process " +
                               std::to_string(::getpid()) + " on .* since 20[0-9-]+ [0-9:]+ .*Wait";
    for (const Mode mode : {Mode::fresh, Mode::overwrite, Mode::restart})
      refused("locked", base + "a/b", mode, holder);
    check::equal("then nothing is removed", content("a/b/probes.csv"), "1");
    check::is_true("its lock", there("a/b/lock"));
    check::equal("no warning", fresh.warning(), "");
    fs::remove(base + "a/b/probes.csv");
  }
  check::is_true("the lock is gone", !there("a/b/lock"));

  // A folder without a run, also one with the user's files, is taken.
  write("a/b/notes.txt");
  OutputDirectory(base + "a/b", Mode::fresh, MPI_COMM_SELF);
  check::is_true("foreign file stays", there("a/b/notes.txt"));

  for (const std::string name : {"summary.json", "parameters.prm", "checkpoint/mesh"})
  {
    write("a/b/" + name);
    refused("holds a run: " + name, base + "a/b", Mode::fresh,
            "a/b: .*holds a run.*--overwrite.*--restart.*--output");
    fs::remove(base + "a/b/" + name);
  }
  write("a/b/checkpoint/mesh.new");
  OutputDirectory(base + "a/b", Mode::fresh, MPI_COMM_SELF);
  refused("an unfinished checkpoint is none", base + "a/b", Mode::restart,
          "no checkpoint.*--output");
  refused("restart of nothing", base + "c", Mode::restart, "no checkpoint.*--restart");
  check::is_true("restart of nothing creates nothing", !there("c"));

  write("a/b/checkpoint/mesh");
  write("a/b/probes.csv");
  OutputDirectory(base + "a/b", Mode::restart, MPI_COMM_SELF);
  check::is_true("restart removes nothing",
                 there("a/b/checkpoint/mesh") && there("a/b/probes.csv"));

  const std::vector<std::string> of_a_run = {
      "parameters.prm",     "log.txt",        "summary.json", "probes.csv",
      "power.csv",          "refinement.csv", "wave.csv",     "modes.csv",
      "runs.csv",           "fields.pvd",     "fields/1.vtu", "fields/1.pvtu",
      "checkpoint/x/y",     "input/beam.prm", "plots/a.png",  "citation.bib",
      "view-in-paraview.py"};
  const std::vector<std::string> of_the_user = {
      "notes.txt", "probes.csv.old", "measured.csv", "fields/view.pvsm", "plots.txt", "x/log.txt"};
  for (const std::string &name : of_a_run)
    write("a/b/" + name);
  for (const std::string &name : of_the_user)
    write("a/b/" + name);
  refused("overwrite spares what the run reads", base + "a/b", Mode::overwrite,
          "would remove '.*a/b/input/beam.prm'.*--output",
          {base + "other.prm", base + "a/b/input/beam.prm"});
  check::is_true("then nothing is removed", there("a/b/log.txt") && there("a/b/input/beam.prm"));
  OutputDirectory(base + "a/b", Mode::overwrite, MPI_COMM_SELF, {base + "beam.prm"});
  for (const std::string &name : of_a_run)
    check::is_true("removed: " + name, !there("a/b/" + name));
  for (const std::string &name : of_the_user)
    check::is_true("kept: " + name, there("a/b/" + name));
  check::is_true("folders again",
                 there("a/b/fields") && there("a/b/checkpoint") && there("a/b/input"));

  // What only the run knew the names of, and the folders of runs of their own.
  {
    const OutputDirectory study(base + "s", Mode::fresh, MPI_COMM_SELF);
    write("s/summary.json");
    check::equal("file of the case", study.file_of_case("wave-a.csv"), base + "s/wave-a.csv");
    study.file_of_case("wave-a.csv");
    study.file_of_case("run-1/");
    check::equal("each is listed once", content("s/other-files.txt"), "wave-a.csv\nrun-1/\n");
    const OutputDirectory one(study.file_of_case("run-1/"), Mode::fresh, MPI_COMM_SELF);
    one.file_of_case("harmonic-1.csv");
    refused("locked by a run of its own", base + "s/run-1", Mode::fresh, "another run works");
  }
  write("s/other-files.txt", "wave-a.csv\nrun-1/\n../notes.txt\n..\n.\n\nrun-1/mine.txt\n/\n");
  write("notes.txt");
  for (const std::string name : {"wave-a.csv", "run-1/harmonic-1.csv", "run-1/modes.csv"})
    write("s/" + name);
  for (const std::string name : {"wave-mine.csv", "run-1/mine.txt", "run-2/log.txt"})
    write("s/" + name);
  {
    const OutputDirectory of_run(base + "s/run-1", Mode::fresh, MPI_COMM_SELF);
    refused("a run works in a folder of the run", base + "s", Mode::overwrite, "another run works");
    check::is_true("then nothing is removed", there("s/wave-a.csv") && there("s/run-1/modes.csv"));
  }
  OutputDirectory(base + "s", Mode::overwrite, MPI_COMM_SELF);
  for (const std::string name :
       {"wave-a.csv", "run-1/harmonic-1.csv", "run-1/modes.csv", "other-files.txt"})
    check::is_true("removed: " + name, !there("s/" + name));
  for (const std::string name : {"wave-mine.csv", "run-1/mine.txt", "run-2/log.txt"})
    check::is_true("kept: " + name, there("s/" + name));
  check::is_true("nothing outside is removed", there("notes.txt"));
  write("s/summary.json");
  write("s/other-files.txt", "run-1/\n");
  fs::remove(base + "s/run-1/mine.txt");
  OutputDirectory(base + "s", Mode::overwrite, MPI_COMM_SELF);
  check::is_true("an empty folder of a run goes", !there("s/run-1"));

  write("l/lock", "my own");
  refused("a user's file in the place of the lock", base + "l", Mode::fresh,
          "cannot be prepared.*lock' is in the place of the lock");
  check::equal("it stays", content("l/lock"), "my own");

  // Where there is no run there is nothing to overwrite: an input/ or plots/ there is the user's.
  write("d/input/table.csv");
  write("d/plots/a.png");
  OutputDirectory(base + "d", Mode::overwrite, MPI_COMM_SELF);
  check::is_true("overwrite without a run", there("d/input/table.csv") && there("d/plots/a.png"));

  write("e");
  refused("a file", base + "e", Mode::fresh, "file, not a folder.*--output");
  refused("a file, overwrite", base + "e", Mode::overwrite, "file, not a folder");
  refused("cannot be created", "/proc/continua/a", Mode::fresh, "cannot be prepared.*--output");
  refused("below a file", base + "e/f", Mode::fresh, "cannot be prepared");
  refused("not writable", "/proc", Mode::fresh, "not writable|cannot be prepared");

  write("in/beam.prm", "1");
  write("in/one/table.csv", "2");
  write("in/two/table.csv", "3");
  write("in/table-2.csv", "4");
  const OutputDirectory copies(base + "g", Mode::fresh, MPI_COMM_SELF);
  copies.copy_inputs({base + "in/beam.prm", base + "in/one/table.csv", base + "in/two/table.csv",
                      base + "in/table-2.csv", base + "in/../in/beam.prm"});
  check::is_true(
      "the names of copies",
      OutputDirectory::names_of_copies({base + "in/one/table.csv", base + "in/two/table.csv"}) ==
          std::map<std::string, std::string>(
              {{(fs::current_path() / base / "in/one/table.csv").lexically_normal(),
                "input/table.csv"},
               {(fs::current_path() / base / "in/two/table.csv").lexically_normal(),
                "input/table-2.csv"}}));
  check::equal("copied", content("g/input/beam.prm"), "1");
  check::equal("first of a name", content("g/input/table.csv"), "2");
  check::equal("second of a name", content("g/input/table-2.csv"), "3");
  check::equal("name that was taken", content("g/input/table-2-2.csv"), "4");
  check::is_true("a file named twice is copied once", !there("g/input/beam-2.prm"));
  copies.copy_inputs({base + "g/input/beam.prm"});
  check::equal("the copy itself", content("g/input/beam.prm"), "1");
  check::throws<RunError>(
      "a missing file", [&copies]() { copies.copy_inputs({base + "in/no.prm"}); }, "in/no.prm");

  // All ranks of a communicator fail alike.
  const std::string common = "output-directory-test-common";
  unsigned int n_caught = 0;
  if (rank == 0)
  {
    fs::create_directories(common);
    std::ofstream(common + "/summary.json") << "{}";
  }
  try
  {
    OutputDirectory directory(common, Mode::fresh, MPI_COMM_WORLD);
  }
  catch (const InputError &error)
  {
    n_caught = std::string(error.what()).find("holds a run") != std::string::npos ? 1 : 0;
  }
  check::is_true("all ranks refuse", dealii::Utilities::MPI::sum(n_caught, MPI_COMM_WORLD) ==
                                         dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
  if (rank == 0)
    fs::remove_all(common);
  fs::remove_all(base);
}
} // namespace test_of_output_directory
