#include <continua/mesh/cells_in_tree_order.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/grid/tria.h>

namespace Continua
{
using namespace dealii;

namespace
{
template <typename MeshType>
void collect_active_cells(const typename MeshType::cell_iterator &cell,
                          std::vector<typename MeshType::active_cell_iterator> &cells)
{
  if (cell->is_active())
    cells.push_back(cell);
  else
    for (unsigned int child = 0; child < cell->n_children(); ++child)
      collect_active_cells<MeshType>(cell->child(child), cells);
}
} // namespace

template <typename MeshType>
std::vector<typename MeshType::active_cell_iterator> cells_in_tree_order(const MeshType &mesh)
{
  std::vector<typename MeshType::active_cell_iterator> cells;
  for (const auto &cell : mesh.cell_iterators_on_level(0))
    collect_active_cells<MeshType>(cell, cells);
  return cells;
}

template std::vector<Triangulation<2>::active_cell_iterator>
cells_in_tree_order(const Triangulation<2> &);
template std::vector<Triangulation<3>::active_cell_iterator>
cells_in_tree_order(const Triangulation<3> &);
template std::vector<DoFHandler<2>::active_cell_iterator>
cells_in_tree_order(const DoFHandler<2> &);
template std::vector<DoFHandler<3>::active_cell_iterator>
cells_in_tree_order(const DoFHandler<3> &);
} // namespace Continua
