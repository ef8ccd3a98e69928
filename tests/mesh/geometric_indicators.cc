// Which cells are near an interface, and where an expression is positive.

#include <continua/mesh/adaptation.h>
#include <continua/mesh/geometric_indicators.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_generator.h>

#include "../unit_test.h"

namespace test_of_geometric_indicators
{
using namespace dealii;
using namespace Continua;

namespace
{
/// The number of cells where `expected` is not what the indicator says.
template <int dim>
unsigned int n_wrong(const Triangulation<dim> &mesh,
                     const Vector<float> &indicator,
                     const std::function<bool(const TriaAccessor<dim, dim, dim> &)> &expected)
{
  unsigned int n = 0;
  for (const auto &cell : mesh.active_cell_iterators())
    n += (indicator[cell->active_cell_index()] > 0.f) != expected(*cell) ? 1 : 0;
  return n;
}

/// Cells of 1/8 about an interface x = 0.5 from y = 0 to 0.5: solid below, at the left.
template <int dim>
void test_band()
{
  const std::string name = dim == 2 ? "2-D: " : "3-D: ";
  parallel::distributed::Triangulation<dim> mesh(MPI_COMM_WORLD);
  GridGenerator::subdivided_hyper_cube(mesh, 2);
  for (const auto &cell : mesh.active_cell_iterators())
    cell->set_material_id(cell->center()[0] < 0.5 && cell->center()[1] < 0.5 ? 1 : 0);
  mesh.refine_global(2);
  // The rim of the solid: x = 0.5 for y < 0.5, and y = 0.5 for x < 0.5.
  const auto distance = [](const Point<dim> &point)
  {
    const double beyond_y = std::max(point[1] - 0.5, 0.), beyond_x = std::max(point[0] - 0.5, 0.);
    return std::min(std::hypot(point[0] - 0.5, beyond_y), std::hypot(point[1] - 0.5, beyond_x));
  };
  for (const double width : {0., 0.2, 0.3})
  {
    const auto expected = [&](const TriaAccessor<dim, dim, dim> &cell)
    {
      double nearest = 1.;
      unsigned int n_at_it = 0;
      for (const unsigned int v : cell.vertex_indices())
      {
        nearest = std::min(nearest, distance(cell.vertex(v)));
        n_at_it += distance(cell.vertex(v)) < 1e-12 ? 1 : 0;
      }
      return nearest < width || n_at_it >= (dim == 2 ? 2 : 4);
    };
    check::is_true(name + "band of " + std::to_string(width),
                   n_wrong<dim>(mesh, interface_band(mesh, {false, true}, width), expected) == 0);
  }
  check::is_true(name + "no interface",
                 interface_band(mesh, {true, true}, 0.2).linfty_norm() == 0.f);
}
} // namespace

UNIT_TEST(geometric_indicators)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_band<2>();
  test_band<3>();

  // A window of 0.25 that travels with 2 m/s: whatever it touches is divided twice and, once it has
  // passed, put together.
  parallel::distributed::Triangulation<2> mesh(
      MPI_COMM_WORLD, Triangulation<2>::limit_level_difference_at_vertices);
  GridGenerator::subdivided_hyper_rectangle(mesh, {8, 1}, Point<2>(), Point<2>(4., 0.5));
  AdaptationParameters parameters;
  parameters.indicators = {Indicator::expression};
  parameters.strategy = AdaptationStrategy::threshold;
  parameters.maximum_level = 2;
  const Expression window("abs(x - 0.25 - 2*t) < 0.125", Dimensions::none);
  check::is_true("an expression is geometric", parameters.is_geometric());
  for (const double time : {0., 0.5, 1.75})
  {
    unsigned int n_changes = 0;
    while (n_changes < 10 && flag_cells(mesh, expression_indicator(mesh, window, time), parameters))
    {
      mesh.execute_coarsening_and_refinement();
      ++n_changes;
    }
    bool followed = true, left = true;
    for (const auto &cell : mesh.active_cell_iterators())
    {
      const double distance = std::abs(cell->center()[0] - 0.25 - 2. * time);
      followed = followed && (distance > 0.12 || cell->level() == 2);
      left = left && (distance < 1.3 || cell->level() == 0);
    }
    check::is_true("the mesh follows to t = " + std::to_string(time),
                   followed && left && n_changes <= 3);
  }
}
} // namespace test_of_geometric_indicators
