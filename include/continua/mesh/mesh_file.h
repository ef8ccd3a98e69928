#ifndef continua_mesh_mesh_file_h
#define continua_mesh_mesh_file_h

#include <deal.II/grid/tria.h>

#include <string>
#include <vector>

namespace Continua
{
/**
 * The mesh as the text of a .vtu file: the cells, and the faces of the boundary as cells of their
 * own. `region` and `boundary` are the place of a cell's or face's name in the arrays `regions` and
 * `boundaries` of the file's field data, -1 where it has none. Coordinates are in m. The mesh is
 * that of one rank.
 */
template <int dim>
std::string mesh_file(const dealii::Triangulation<dim> &triangulation,
                      const std::vector<std::string> &regions,
                      const std::vector<std::string> &boundaries);

/// Writes the text of mesh_file() to `file`, whose name ends in .vtu. Throws InputError if the file
/// exists and is none of these, RunError if it cannot be written.
void write_mesh_file(const std::string &file, const std::string &text);
} // namespace Continua

#endif
