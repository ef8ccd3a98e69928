#ifndef continua_mesh_cells_in_tree_order_h
#define continua_mesh_cells_in_tree_order_h

#include <vector>

namespace Continua
{
/**
 * The active cells that this rank has, coarse cell by coarse cell and child by child. deal.II's own
 * order follows the order in which cells were made, which a mesh that is read from a checkpoint
 * does not share with the run that wrote it: sums over cells would have another round-off.
 * `MeshType`: a Triangulation or DoFHandler.
 */
template <typename MeshType>
std::vector<typename MeshType::active_cell_iterator> cells_in_tree_order(const MeshType &mesh);
} // namespace Continua

#endif
