// Which cells are flagged by their indicators.

#include <continua/mesh/adaptation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>

#include "../unit_test.h"

using namespace dealii;
using namespace Continua;

UNIT_TEST(adaptation)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_cube(mesh, 4);
  AdaptationParameters parameters;
  parameters.refine_fraction = 0.25;
  parameters.coarsen_fraction = 0.;

  // Four cells stand out; their values differ by round-off only, as those of symmetric cells do.
  Vector<float> indicators(mesh.n_active_cells());
  for (const auto &cell : mesh.active_cell_iterators())
    indicators[cell->active_cell_index()] =
        cell->center()[0] < 0.25 ? 2.f * (1.f + 1e-7f * cell->active_cell_index()) : 1.f;
  check::is_true("something is flagged", flag_cells(mesh, indicators, parameters));
  unsigned int n_flagged = 0, n_wrong = 0;
  for (const auto &cell : mesh.active_cell_iterators())
    if (cell->refine_flag_set())
    {
      ++n_flagged;
      n_wrong += cell->center()[0] > 0.25 ? 1 : 0;
    }
  check::is_true("the four with the largest indicator", n_flagged == 4 && n_wrong == 0);
  mesh.execute_coarsening_and_refinement();
  check::is_true("each divided into four", mesh.n_global_active_cells() == 12 + 16);

  parameters.maximum_level = 1;
  indicators.reinit(mesh.n_active_cells());
  for (const auto &cell : mesh.active_cell_iterators())
    indicators[cell->active_cell_index()] = cell->level() == 1 ? 5.f : 1e-3f;
  parameters.refine_fraction = 0.5;
  flag_cells(mesh, indicators, parameters);
  bool beyond = false;
  for (const auto &cell : mesh.active_cell_iterators())
    beyond = beyond || (cell->level() == 1 && cell->refine_flag_set());
  check::is_true("not beyond the maximum level", !beyond);
}
