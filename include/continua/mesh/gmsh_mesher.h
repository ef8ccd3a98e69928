#ifndef continua_mesh_gmsh_mesher_h
#define continua_mesh_gmsh_mesher_h

#include <string>

namespace Continua
{
/**
 * Meshes a .geo file with the library of gmsh, without the user's configuration files, and returns
 * the text of the mesh file (MSH 4.1, ASCII). Rank 0 of MPI_COMM_WORLD lets a process of its own do
 * it (see mesh_in_own_process()) and sends the text to all others, so that every rank has the same
 * mesh: collective. `time_limit`: of that process [s].
 *
 * Throws InputError on every rank, with file and line for what check_gmsh_script() refuses, else
 * with gmsh's own message.
 */
std::string
mesh_with_gmsh(const std::string &geo_file, unsigned int dimension, double time_limit = 600.);

/// From now on .geo files may run programs and write files in this program: the user has said so.
void allow_mesh_commands();
} // namespace Continua

#endif
