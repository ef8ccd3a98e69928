// Every ghost gets the numbers of its owner, of another length for each cell and some with none:
// compared with what the ghost's own place says they must be.

#include <continua/mesh/ghost_exchange.h>

#include "../unit_test.h"

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

namespace test_of_ghost_exchange
{
using namespace Continua;
using namespace dealii;

namespace
{
/// As many numbers as the cell's place along x says, 0 to 3, and what they are follows from its
/// centre.
template <int dim>
std::vector<double> numbers_at(const Point<dim> &centre)
{
  std::vector<double> numbers(static_cast<unsigned int>(4. * centre[0]));
  for (unsigned int i = 0; i < numbers.size(); ++i)
    numbers[i] = centre[dim - 1] + 1e15 * i;
  return numbers;
}

template <int dim>
void check_exchange(const std::string &name)
{
  parallel::distributed::Triangulation<dim> mesh(MPI_COMM_WORLD);
  GridGenerator::hyper_cube(mesh);
  mesh.refine_global(2);
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned() && cell->center()[0] < 0.3)
      cell->set_refine_flag();
  mesh.execute_coarsening_and_refinement();

  unsigned int n_taken = 0, n_wrong = 0, n_ghosts = 0;
  exchange_with_ghosts<dim>(
      mesh, [](const auto &cell) { return numbers_at<dim>(cell->center()); },
      [&](const auto &cell, const std::vector<double> &numbers)
      {
        ++n_taken;
        n_wrong += !cell->is_ghost() || numbers != numbers_at<dim>(cell->center());
      });
  for (const auto &cell : mesh.active_cell_iterators())
    n_ghosts += cell->is_ghost();
  n_ghosts = Utilities::MPI::sum(n_ghosts, MPI_COMM_WORLD);
  n_taken = Utilities::MPI::sum(n_taken, MPI_COMM_WORLD);
  n_wrong = Utilities::MPI::sum(n_wrong, MPI_COMM_WORLD);
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return;
  check::is_true(name + ": there are ghosts on several ranks only",
                 (n_ghosts > 0) == (n_ranks > 1));
  check::is_true(name + ": each ghost gets its owner's numbers once",
                 n_taken == n_ghosts && n_wrong == 0);
}
} // namespace

UNIT_TEST(ghost_exchange)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_exchange<2>("plane");
  check_exchange<3>("space");
}
} // namespace test_of_ghost_exchange
