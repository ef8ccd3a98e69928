// Cells in the order of the tree, whatever the order in which they were made.

#include <continua/mesh/cells_in_tree_order.h>

#include "../unit_test.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <string>

namespace test_of_cells_in_tree_order
{
using namespace dealii;

namespace
{
/// Four coarse cells in a row, of which these are divided one after the other.
std::string order_after(const std::vector<unsigned int> &divided)
{
  Triangulation<2> mesh;
  GridGenerator::subdivided_hyper_rectangle(mesh, {4, 1}, Point<2>(), Point<2>(4., 1.));
  for (const unsigned int place : divided)
  {
    for (const auto &cell : mesh.cell_iterators_on_level(0))
      if (cell->is_active() && cell->center()[0] == place + 0.5)
        cell->set_refine_flag();
    mesh.execute_coarsening_and_refinement();
  }
  std::string names;
  for (const auto &cell : Continua::cells_in_tree_order(mesh))
    names += cell->id().to_string() + " ";
  return names;
}
} // namespace

UNIT_TEST(cells_in_tree_order)
{
  // The names of the cells: coarse cell, number of divisions, child.
  const std::string expected = "0_0: 1_1:0 1_1:1 1_1:2 1_1:3 2_0: 3_1:0 3_1:1 3_1:2 3_1:3 ";
  check::is_true("divided from left to right", order_after({1, 3}) == expected);
  check::is_true("divided from right to left", order_after({3, 1}) == expected);
}
} // namespace test_of_cells_in_tree_order
