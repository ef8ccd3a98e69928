#ifndef continua_mesh_structured_extent_h
#define continua_mesh_structured_extent_h

#include <continua/mesh/mesh_extent.h>

#include <vector>

namespace Continua
{
/// The extent of a mesh of so many cells in each direction.
MeshExtent structured_extent(const std::vector<unsigned int> &cells);

/// Numbers of cells in each direction whose product is about `most_cells` or less: the largest
/// numbers are divided first, none is less than 1.
std::vector<unsigned int> coarsened_cells(std::vector<unsigned int> cells, double most_cells);
} // namespace Continua

#endif
