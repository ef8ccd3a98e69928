#ifndef continua_mesh_gmsh_script_h
#define continua_mesh_gmsh_script_h

#include <string>

namespace Continua
{
/**
 * Looks through a .geo file, and through the files that it includes or merges, for statements that
 * do more than to describe a geometry and to read files: SystemCall and System,
 * NonBlockingSystemCall, OnelabRun, Plugin, Field ExternalProcess, options of Solver, Printf into a
 * file, Save, Print, CreateDir, SendToServer, Exit, Abort, StringToName (which makes a command of
 * any text), and a merge of a file for which gmsh starts a program (.gz, .py, .pro, .m, .exe).
 * Throws InputError with file, line and remedy for the first one, and where it cannot be seen which
 * file is merged.
 *
 * Names, strings and comments are those of gmsh's own lexer (Parser/Gmsh.l of gmsh 4.8.4), and
 * upper and lower case matter as there. gmsh itself reads what a condition leaves out by other
 * rules than what it executes, so the look alone is no wall: the process that makes the mesh can do
 * none of it, either (see gmsh_process.h).
 */
void check_gmsh_script(const std::string &geo_file);
} // namespace Continua

#endif
