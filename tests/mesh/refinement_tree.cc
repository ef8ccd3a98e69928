// A mesh that was refined and coarsened by chance comes back from an archive, cell by cell: the
// cells are compared by deal.II's own names of them.

#include <continua/base/collective.h>
#include <continua/base/input_error.h>
#include <continua/mesh/refinement_tree.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include "../unit_test.h"

#include <algorithm>
#include <filesystem>
#include <random>
#include <sstream>

namespace test_of_refinement_tree
{
using namespace Continua;
using namespace dealii;

namespace
{
template <int dim>
using Mesh = parallel::distributed::Triangulation<dim>;

template <int dim>
std::unique_ptr<Mesh<dim>> coarse_mesh(const unsigned int n_cells)
{
  auto mesh = std::make_unique<Mesh<dim>>(MPI_COMM_WORLD,
                                          Triangulation<dim>::limit_level_difference_at_vertices);
  GridGenerator::subdivided_hyper_cube(*mesh, n_cells);
  return mesh;
}

/// The names of all active cells, in order.
template <int dim>
std::vector<std::string> names_of_cells(const Mesh<dim> &mesh)
{
  std::string own;
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->is_locally_owned())
      own += cell->id().to_string() + "\n";
  std::vector<std::string> names;
  for (const std::string &part : all_gather(MPI_COMM_WORLD, own))
  {
    std::istringstream lines(part);
    for (std::string line; std::getline(lines, line);)
      names.push_back(line);
  }
  std::sort(names.begin(), names.end());
  return names;
}

template <int dim>
void change_by_chance(Mesh<dim> &mesh, const unsigned int n_changes)
{
  // Of the rank's own cells only: the mesh need not be the same on other numbers of ranks.
  std::mt19937 chance(7 + Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
  for (unsigned int change = 0; change < n_changes; ++change)
  {
    for (const auto &cell : mesh.active_cell_iterators())
      if (cell->is_locally_owned())
      {
        if (chance() % 4 == 0)
          cell->set_refine_flag();
        else if (chance() % 2 == 0)
          cell->set_coarsen_flag();
      }
    mesh.execute_coarsening_and_refinement();
  }
}

template <int dim>
void test(const std::string &name, const unsigned int n_changes)
{
  const auto mesh = coarse_mesh<dim>(2);
  change_by_chance(*mesh, n_changes);
  ArchiveWriter writer;
  save_refinement<dim>(*mesh, writer);
  const std::string file = "refinement_tree_" + std::to_string(dim) + "_" +
                           std::to_string(Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    writer.write(file);
  MPI_Barrier(MPI_COMM_WORLD);
  const ArchiveReader archive(file);

  const auto again = coarse_mesh<dim>(2);
  load_refinement<dim>(archive, *again);
  check::is_true(name + ": has levels", mesh->n_global_levels() > 2);
  check::is_true(name + ": the same cells", names_of_cells(*again) == names_of_cells(*mesh));
  const auto other = coarse_mesh<dim>(1);
  check::throws<RunError>(
      name + ": another coarse mesh", [&]() { load_refinement<dim>(archive, *other); },
      "its refined cells give .* cells instead of " +
          std::to_string(mesh->n_global_active_cells()));
  MPI_Barrier(MPI_COMM_WORLD);
  std::filesystem::remove(file);
}
} // namespace

UNIT_TEST(refinement_tree)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    std::cout.setstate(std::ios::failbit);
  test<2>("plane", 6);
  test<3>("space", 4);
}
} // namespace test_of_refinement_tree
