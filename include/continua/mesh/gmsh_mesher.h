#ifndef continua_mesh_gmsh_mesher_h
#define continua_mesh_gmsh_mesher_h

#include <string>

namespace Continua
{
/**
 * Meshes a .geo file with the library of gmsh, without the user's configuration files, and returns
 * the text of the mesh file (MSH 4.1, ASCII). Rank 0 of MPI_COMM_WORLD does it and sends the text
 * to all others, so that every rank has the same mesh: collective. Throws InputError with gmsh's
 * own message, on every rank.
 */
std::string mesh_with_gmsh(const std::string &geo_file, unsigned int dimension);
} // namespace Continua

#endif
