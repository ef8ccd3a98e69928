#ifndef continua_program_script_h
#define continua_program_script_h

#include <optional>
#include <string>

namespace Continua
{
/// The path of a script that came with the program, which may not be there. Throws InputError if
/// nothing of the program's files is.
std::string script_file(const std::string &name);

/**
 * `continua report ...` and `continua plot ...` are scripts, which came with the program: the
 * process becomes that script, with the arguments that follow. Returns the exit status of a wrong
 * input if the script is not there or cannot be started, after a message; nothing if the command
 * line names no script.
 */
std::optional<int> become_script(int argc, char **argv);
} // namespace Continua

#endif
