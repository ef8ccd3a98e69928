// Ranks that read the same input, or another one. That a rank alone ends the others is shown by the
// attack `ranks`.

#include <continua/base/input_error.h>
#include <continua/base/parameter_file.h>
#include <continua/base/rank_agreement.h>

#include "../unit_test.h"

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>
#include <new>

namespace test_of_rank_agreement
{
using namespace Continua;

namespace
{
/// Each rank has a folder of its own, as nodes have disks of their own.
std::string write(const std::string &name, const std::string &text)
{
  const std::string folder =
      "rank_agreement_test_" +
      std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD)) + "/" +
      std::to_string(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)) + "/";
  std::filesystem::create_directories(folder);
  std::ofstream(folder + name) << text;
  return folder + name;
}
} // namespace

UNIT_TEST(rank_agreement)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const bool is_alone = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
  if (rank != 0)
    std::cout.setstate(std::ios::failbit);
  const RankAgreement agreement(MPI_COMM_WORLD);

  const auto same = [](const std::string &text, const std::string &table)
  {
    write("table.csv", table);
    ParameterFile file(write("case.prm", text));
    std::string path;
    file.root().add_input_file("Table", path, "A table");
    require_same_input(file, MPI_COMM_WORLD);
  };
  same("set Table = table.csv\n", "1\n");
  check::is_true("the same input", true);
  const auto refused =
      [&](const std::string &name, const std::string &text, const std::string &table)
  {
    if (is_alone)
    {
      same(text, table);
      check::is_true(name, true);
    }
    else
      check::throws<InputError>(
          name, [&]() { same(text, table); }, "rank 1 .*reads another content of the file");
  };
  const std::string at_rank_1 = rank == 1 ? "# more\n" : "";
  refused("another parameter file", "set Table = table.csv\n" + at_rank_1, "1\n");
  refused("another table", "set Table = table.csv\n", "1\n" + at_rank_1);

  // All ranks have an error: nobody is ended.
  RankAgreement::wait_for_all("an error", exit_status_of_failure);
  check::is_true("an error of all ranks", true);
  check::equal("a failure of the run", text_of_failure(RunError("no")), "no");
  check::is_true("no memory", text_of_failure(std::bad_alloc()).find("memory of the machine") !=
                                  std::string::npos);
  check::is_true(
      "a library's text",
      text_of_failure(std::runtime_error("odd")).find("no better reason than the text below") !=
          std::string::npos);
}
} // namespace test_of_rank_agreement
