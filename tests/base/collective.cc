// What ranks exchange: numbers and texts of other lengths on each rank, empty ones, and nothing at
// all. The expected values are counted out from the numbers of the ranks.

#include <continua/base/collective.h>

#include "../unit_test.h"

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace test_of_collective
{
using namespace Continua;

namespace
{
/// Prints once, and only what holds on every rank.
void check_everywhere(const std::string &name, const bool holds)
{
  const int all = dealii::Utilities::MPI::min(holds ? 1 : 0, MPI_COMM_WORLD);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    check::is_true(name, all == 1);
}
} // namespace

UNIT_TEST(collective)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const MPI_Comm world = MPI_COMM_WORLD;
  const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(world);
  const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(world);
  // Rank r has r letters and r numbers, so that rank 0 has none.
  const std::string letters(rank, 'x');
  const std::vector<unsigned int> numbers(rank, 7 * rank);

  check_everywhere("a text of rank 0",
                   broadcast(world, rank == 0 ? std::string("from 0") : letters) == "from 0");
  check_everywhere("an empty text of rank 0", broadcast(world, letters).empty());
  check_everywhere("numbers of rank 0",
                   broadcast(world, rank == 0 ? std::vector<double>{0.1, -2.}
                                              : std::vector<double>(rank + 3, 1.)) ==
                       std::vector<double>{0.1, -2.});
  check_everywhere("no number of rank 0", broadcast(world, std::vector<double>(rank, 1.)).empty());
  check_everywhere("texts of rank 0, one of them empty",
                   broadcast(world, rank == 0 ? std::vector<std::string>{"one", "", "three"}
                                              : std::vector<std::string>{}) ==
                       std::vector<std::string>{"one", "", "three"});

  bool holds = true;
  const auto of_double = all_gather(world, 0.5 * rank);
  const auto of_int = all_gather(world, 3u * rank);
  const auto of_long = all_gather(world, (1ul << 40) + rank);
  const auto of_text = all_gather(world, letters);
  const auto of_numbers = all_gather(world, numbers);
  for (unsigned int r = 0; r < n_ranks; ++r)
    holds = holds && of_double.at(r) == 0.5 * r && of_int.at(r) == 3 * r &&
            of_long.at(r) == (1ul << 40) + r;
  check_everywhere("a number of each rank", holds && of_double.size() == n_ranks);
  holds = of_text.size() == n_ranks && of_numbers.size() == n_ranks;
  for (unsigned int r = 0; r < n_ranks; ++r)
    holds = holds && of_text[r] == std::string(r, 'x') &&
            of_numbers[r] == std::vector<unsigned int>(r, 7 * r);
  check_everywhere("texts and numbers of other lengths on each rank", holds);
  const auto none = all_gather(world, std::vector<unsigned int>());
  check_everywhere("nothing of any rank",
                   none.size() == n_ranks && std::all_of(none.begin(), none.end(),
                                                         [](const auto &x) { return x.empty(); }));
}
} // namespace test_of_collective
