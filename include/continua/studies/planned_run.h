#ifndef continua_studies_planned_run_h
#define continua_studies_planned_run_h

#include <continua/base/command_line.h>

#include <string>
#include <vector>

namespace Continua
{
/// One of several runs of a file: with other entries, in a folder of its own.
struct PlannedRun
{
  std::string name;         ///< of its folder
  CommandLine command_line; ///< with its entries set
  std::string identity;     ///< of the case, and of what else its results depend on
  double memory = 0.;       ///< what it may hold, by estimate [bytes]; 0: not known
};

/// "taylor-hood" from "Taylor hood", "size-minus-1-m" from "size -1 m".
std::string folder_name(const std::string &text);

/// The path "Section/Key" without blanks that do not count, and with quotes only where it needs
/// them.
std::string tidy_path(const std::string &path);

/// Sets an entry, "Section/Key", over the file and over what the command line says of it.
void set_entry(CommandLine &command_line, const std::string &path, const std::string &value);

/// Takes back all that the command line says of a section and its entries.
void remove_entries_of(CommandLine &command_line, const std::string &section);

/// The command that performs the run, as a shell reads it.
std::string text_of(const CommandLine &command_line);

/// The arguments of this program, behind its name, that perform the run.
std::vector<std::string> arguments_of(const CommandLine &command_line);
} // namespace Continua

#endif
