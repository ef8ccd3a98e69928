#include "../unit_test.h"
#include "fake_solver.h"
#include "text_file.h"

#include <continua/base/input_error.h>
#include <continua/postprocess/field_writer.h>
#include <continua/postprocess/view_in_paraview.h>

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <set>

namespace test_of_field_writer
{
using namespace Continua;

namespace
{
/// The files and folders that were flushed, by name.
std::set<std::string> flushed;
/// How long a flush takes at least.
unsigned int milliseconds_of_flush = 0;
} // namespace

/// In place of the system's.
extern "C" int fsync(const int descriptor)
{
  std::error_code error;
  flushed.insert(std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), error)
                     .filename());
  usleep(1000 * milliseconds_of_flush);
  return static_cast<int>(syscall(SYS_fsync, descriptor));
}

namespace
{
/// A list of times and files.
std::string list_of(const std::string &entries)
{
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  "
         "<Collection>\n" +
         entries + "  </Collection>\n</VTKFile>\n";
}

std::string entry(const std::string &time, const std::string &file)
{
  return "    <DataSet timestep=\"" + time + "\" part=\"0\" file=\"fields/" + file + "\"/>\n";
}

/// How many states the list has; 0 if it is not whole.
unsigned int n_listed()
{
  MPI_Barrier(MPI_COMM_WORLD);
  const std::string text = read_text("fields.pvd"), end = "  </Collection>\n</VTKFile>\n";
  MPI_Barrier(MPI_COMM_WORLD);
  if (text.size() < end.size() || text.substr(text.size() - end.size()) != end)
    return 0;
  unsigned int n = 0;
  for (std::size_t i = text.find("<DataSet"); i != std::string::npos;
       i = text.find("<DataSet", i + 1))
    ++n;
  return n;
}

/// The first number of that attribute.
unsigned int number(const std::string &text, const std::string &attribute)
{
  return static_cast<unsigned int>(
      std::stoul(text.substr(text.find(attribute + "=\"") + attribute.size() + 2)));
}
} // namespace

UNIT_TEST(field_writer)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit); // one rank speaks
  else
  {
    std::filesystem::remove("fields.pvd");
    std::filesystem::create_directories("fields");
  }
  MPI_Barrier(MPI_COMM_WORLD);
  const std::string suffix = n_ranks > 1 ? ".pvtu" : ".vtu";
  FakeSolver<2> solver;

  // Four cells of 2 x 2 parts with 3 x 3 points each.
  {
    FieldWriter<2> writer(MPI_COMM_WORLD, ".", 2, false);
    writer.resume(0.); // there is nothing yet
    check::is_true("no list without fields", !std::filesystem::exists("fields.pvd"));
    writer.write(solver, 0.);
    writer.write(solver, 0.1);
    writer.write(solver, 0.3);
    check::equal("list", read_text("fields.pvd"),
                 list_of(entry("0", "solution-00000" + suffix) +
                         entry("0.1", "solution-00001" + suffix) +
                         entry("0.3", "solution-00002" + suffix)));
    unsigned int n_cells = 0;
    unsigned int n_points = 0;
    bool units = true;
    for (unsigned int rank = 0; rank < n_ranks; ++rank)
    {
      const std::string text =
          read_text("fields/solution-00002" +
                    (n_ranks > 1 ? "." + std::to_string(rank) : std::string()) + ".vtu");
      n_cells += number(text, "NumberOfCells");
      n_points += number(text, "NumberOfPoints");
      units = units && text.find("Pa") != std::string::npos;
    }
    check::absolute("cells", n_cells, 16., 0.);
    check::absolute("points", n_points, 36., 0.);
    check::is_true("units in the file", units);
    if (n_ranks > 1)
      check::is_true(
          "pieces",
          read_text("fields/solution-00002.pvtu").find("Source=\"solution-00002.1.vtu\"") !=
              std::string::npos);
    else
      check::is_true("pieces", true);

    const std::string view = read_text("view-in-paraview.py");
    check::is_true("script for ParaView, with its place",
                   check::matches(view, "\"/[^\"]*/view-in-paraview.py\"") &&
                       view.find("@FILE@") == std::string::npos);
    check::is_true("quotes in its place",
                   view_in_paraview("/a \"b\" \\ c\n/d").find("\"/a \\\"b\\\" \\\\ c\\n/d\"") !=
                       std::string::npos);

    Summary summary;
    writer.finish(summary);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      summary.write("summary.json");
    check::is_true(
        "units in the summary",
        check::matches(read_text("summary.json"), "\"field units\": \\{\\s*\"pressure\": \"Pa\""));
  }

  // From 0.1 + 0.1 = 0.2 s on, after the entry at 0.3 s was written.
  {
    FieldWriter<2> writer(MPI_COMM_WORLD, ".", 2, true);
    writer.resume(0.2);
    check::equal(
        "list cut", read_text("fields.pvd"),
        list_of(entry("0", "solution-00000" + suffix) + entry("0.1", "solution-00001" + suffix)));
    check::is_true("files of later states are gone",
                   std::filesystem::exists("fields/solution-00001" + suffix) &&
                       !std::filesystem::exists("fields/solution-00002" + suffix) &&
                       !std::filesystem::exists("fields/solution-00002.0.vtu"));
    MPI_Barrier(MPI_COMM_WORLD);
    writer.write(solver, 0.4);
    writer.write(solver, 0.4);
    check::equal("list continued", read_text("fields.pvd"),
                 list_of(entry("0", "solution-00000" + suffix) +
                         entry("0.1", "solution-00001" + suffix) +
                         entry("0.4", "solution-00002" + suffix)));
    const std::string piece = n_ranks > 1 ? ".0.vtu" : ".vtu";
    check::absolute("curved cells",
                    number(read_text("fields/solution-00002" + piece), "NumberOfCells"),
                    n_ranks > 1 ? 2. : 4., 0.);
  }

  // All ranks in one file.
  {
    FieldWriter<2> writer(MPI_COMM_WORLD, ".", 2, false, 1);
    writer.write(solver, 0.);
    check::equal("list of files that ranks share", read_text("fields.pvd"),
                 list_of(entry("0", "solution-00000.vtu")));
    // What this rank has written reaches the disk when a checkpoint asks for it, and is known.
    flushed.clear();
    writer.flush_to_disk();
    check::is_true("flushed",
                   flushed.count("solution-00000.vtu") == 1 && flushed.count("fields") == 1);
    flushed.clear();
    writer.flush_to_disk();
    check::is_true("flushed once", flushed.empty());
    writer.write(solver, 1.);
    MPI_Barrier(MPI_COMM_WORLD);
    std::filesystem::remove("fields/solution-00001.vtu");
    MPI_Barrier(MPI_COMM_WORLD);
    writer.flush_to_disk();
    const std::optional<WrittenTable> list = writer.table();
    const std::string file = "fields.pvd", all = read_text(file);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      check::is_true("known: the list",
                     list->name == file && list->last_time == 1. &&
                         list->all.value() == Checksum::of_file(file, list->all.length()).value() &&
                         all.substr(list->all.length()) == "  </Collection>\n</VTKFile>\n" &&
                         list->without_last_row.value() ==
                             Checksum::of_file(file, list->without_last_row.length()).value() &&
                         list->all.length() - list->without_last_row.length() ==
                             entry("1", "solution-00001.vtu").size());
    const std::string text = read_text("fields/solution-00000.vtu");
    unsigned int n_cells = 0;
    const std::string key = "NumberOfCells";
    for (std::size_t i = text.find(key); i != std::string::npos; i = text.find(key, i + 1))
      n_cells += number(text.substr(i), key);
    check::absolute("cells in one file", n_cells, 16., 0.);
  }

  // Each rank flushes its own piece; the last state would replace the first.
  {
    FieldWriter<2> writer(MPI_COMM_WORLD, ".", 2, false);
    writer.write(solver, 0.);
    flushed.clear();
    writer.flush_to_disk();
    const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const std::string own =
        "solution-00000" + (n_ranks > 1 ? "." + std::to_string(rank) : std::string()) + ".vtu";
    const bool mine = flushed.count(own) == 1 && flushed.count("fields") == 1 &&
                      (rank > 0 || flushed.count("solution-00000" + suffix) == 1) &&
                      flushed.size() == (rank == 0 && n_ranks > 1 ? 3 : 2);
    check::is_true("each rank its own",
                   dealii::Utilities::MPI::min(mine ? 1 : 0, MPI_COMM_WORLD) == 1);
  }
  // A long list is not written with each state where that takes long, and is complete at the end.
  {
    FieldWriter<2> writer(MPI_COMM_WORLD, ".", 1, false);
    for (unsigned int i = 0; i < 99; ++i)
      writer.write(solver, i);
    writer.flush_to_disk();
    milliseconds_of_flush = 100;
    for (unsigned int i = 99; i < 102; ++i)
      writer.write(solver, i);
    check::absolute("states in a list that waits", n_listed(), 100., 0.);
    writer.flush_to_disk();
    check::absolute("states after a flush", n_listed(), 102., 0.);
    writer.write(solver, 102.);
    check::absolute("the next one waits", n_listed(), 102., 0.);
    milliseconds_of_flush = 0;
  }
  check::absolute("states at the end", n_listed(), 103., 0.);
  for (unsigned int i = 0; i < 103; ++i)
    std::filesystem::remove("fields/solution-" + dealii::Utilities::int_to_string(i, 5) + suffix);
  // A limit on the size of files stands for the full disk.
  {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit;
    getrlimit(RLIMIT_FSIZE, &limit);
    const rlim_t before = limit.rlim_cur;
    limit.rlim_cur = 200;
    setrlimit(RLIMIT_FSIZE, &limit);
    // What this test prints may go into a file, too.
    std::string problem;
    try
    {
      FieldWriter<2>(MPI_COMM_WORLD, ".", 2, false).write(solver, 0.);
    }
    catch (const RunError &error)
    {
      problem = error.what();
    }
    limit.rlim_cur = before;
    setrlimit(RLIMIT_FSIZE, &limit);
    check::is_true(
        "full disk",
        check::matches(problem, "^cannot write './fields/solution-00000.*vtu': File too large$"));
  }

  // In three dimensions, and where nothing can be written.
  FakeSolver<3> solid;
  check::throws<RunError>(
      "no such folder",
      [&]() { FieldWriter<3>(MPI_COMM_WORLD, "no such folder", 1, false).write(solid, 0.); },
      "cannot write 'no such folder/fields/solution-00000.*No such file");
}
} // namespace test_of_field_writer
