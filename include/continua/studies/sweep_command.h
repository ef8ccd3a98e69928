#ifndef continua_studies_sweep_command_h
#define continua_studies_sweep_command_h

#include <continua/base/command_line.h>

namespace Continua
{
/// The command line with its --sweep as entries of the section Sweep, and without --sweep: a sweep
/// of the file's own analysis, or more entries for a file that is a sweep itself. Throws InputError
/// if the file cannot be read, or if two --sweep name one entry.
CommandLine with_sweeps(const CommandLine &command_line);
} // namespace Continua

#endif
