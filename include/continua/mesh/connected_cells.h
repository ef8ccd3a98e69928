#ifndef continua_mesh_connected_cells_h
#define continua_mesh_connected_cells_h

#include <deal.II/grid/tria.h>

#include <vector>

namespace Continua
{
/// Numbers the sets of coarse cells that hang together by faces and whose regions, by material id,
/// are of one kind: by index of the coarse cell, from 0 on in the order of their first cells. The
/// coarse mesh is known on every rank.
template <int dim>
std::vector<unsigned int> connected_cells(const dealii::Triangulation<dim> &triangulation,
                                          const std::vector<unsigned int> &kind_of_region);

/// The coarse cell of which a cell is a part.
template <typename Cell>
unsigned int index_of_coarse_cell(Cell cell)
{
  while (cell->level() > 0)
    cell = cell->parent();
  return cell->index();
}
} // namespace Continua

#endif
