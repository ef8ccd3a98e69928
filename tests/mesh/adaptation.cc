// Which cells are flagged by their indicators.

#include <continua/mesh/adaptation.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>

#include "../parameter_text.h"
#include "../unit_test.h"

namespace test_of_adaptation
{
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

  // Thresholds, with a level below which no cell falls. A larger indicator than 0.7 refines, none
  // above 0.1 coarsens.
  ParameterFile file = parameters_of("subsection Adaptivity\nset Every n steps = 1\n"
                                     "set Indicator = kelly\nset Indicator field = pressure\n"
                                     "set Strategy = threshold\nset Refine above = 0.7\n"
                                     "set Coarsen below = 0.1\nset Minimum level = 1\n"
                                     "set Maximum level = 4\nend\n");
  AdaptationParameters threshold;
  threshold.read(file.root().subsection("Adaptivity"), true);
  file.refuse_unknown();
  check::is_true("field of the indicator", threshold.kelly_field == IndicatorField::pressure);
  parallel::distributed::Triangulation<2> square(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_cube(square, 2);
  square.refine_global(2); // four coarse cells, each of 16 on level 2
  const auto divide = [&square, &threshold]()
  {
    Vector<float> values(square.n_active_cells());
    for (const auto &cell : square.active_cell_iterators())
      values[cell->active_cell_index()] = cell->center()[0] < 0.5   ? 0.1f
                                          : cell->center()[1] < 0.5 ? 0.7f
                                                                    : 0.71f;
    const bool flagged = flag_cells(square, values, threshold);
    square.execute_coarsening_and_refinement();
    return flagged;
  };
  check::is_true("thresholds flag", divide());
  // At the top right 64 cells of level 3. Cells differ by one level at most, across corners, too:
  // of the four cells of level 1 at the bottom left the one beside those 64 stays divided.
  const auto count = [&square](const bool left, const bool top, const int level)
  {
    unsigned int n = 0;
    for (const auto &cell : square.active_cell_iterators())
      n += (cell->center()[0] < 0.5) == left && (cell->center()[1] > 0.5) == top &&
                   cell->level() == level
               ? 1
               : 0;
    return n;
  };
  check::absolute("coarsened at the threshold", count(true, false, 1), 3., 0.);
  check::absolute("kept at the threshold", count(false, false, 2), 16., 0.);
  check::absolute("refined above the threshold", count(false, true, 3), 64., 0.);

  // Everything is below the threshold: cells of level 1 go back to level 0 unless 1 is the minimum.
  for (const unsigned int minimum : {1u, 0u})
  {
    parallel::distributed::Triangulation<2> divided(MPI_COMM_WORLD);
    GridGenerator::subdivided_hyper_cube(divided, 2);
    divided.refine_global(1);
    Vector<float> low(divided.n_active_cells());
    low = 0.05f;
    threshold.minimum_level = std::min(minimum, threshold.minimum_level);
    const bool flagged = flag_cells(divided, low, threshold);
    divided.execute_coarsening_and_refinement();
    check::is_true(minimum == 1 ? "not below the minimum level" : "without one",
                   flagged == (minimum == 0) &&
                       divided.n_active_cells() == (minimum == 1 ? 16 : 4));
  }
}
} // namespace test_of_adaptation
