#ifndef continua_mesh_gmsh_process_h
#define continua_mesh_gmsh_process_h

#include <string>

namespace Continua
{
/// What a process of its own is to mesh with the library of gmsh.
struct GmshTask
{
  std::string geo_file;
  unsigned int dimension = 2;
  /// Whether the file may run programs and write files, as gmsh lets it.
  bool allows_commands = false;
  double time_limit = 600.; ///< of the wall clock [s]
};

/**
 * Meshes a file in a process of its own, so that gmsh can neither end this one nor take its memory,
 * and returns the text of the mesh file (MSH 4.1, ASCII), with what is in no physical group. Throws
 * std::runtime_error with the reason if the process ends in any other way than with a whole mesh:
 * an error, with gmsh's last lines, a signal, the end of its time, an exit in the middle. A mesh
 * that is not whole is never returned.
 *
 * The process is this program, started anew with the hidden first argument gmsh_process_argument
 * and without the variables by which a launcher of MPI finds its processes; it never initialises
 * MPI. Its address space and its files are limited to memory_limit_of_gmsh(). Unless the task
 * allows commands, the system refuses to the thread that reads the file to start a program, to open
 * a file for writing, and to make, rename or remove files (seccomp of Linux); on a system that
 * cannot do so nothing is meshed.
 */
std::string mesh_in_own_process(const GmshTask &task);

/// Half of the machine's memory, and 4 GiB at least [bytes].
std::size_t memory_limit_of_gmsh();

/// Whether the program was started by mesh_in_own_process(): main must then do nothing but return
/// run_gmsh_process(), before MPI is initialised.
bool is_gmsh_process(int argc, const char *const *argv);
/// Meshes what the arguments say; the exit status, 0 if the mesh is written.
int run_gmsh_process(int argc, const char *const *argv);
} // namespace Continua

#endif
