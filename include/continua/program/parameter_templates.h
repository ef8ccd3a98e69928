#ifndef continua_program_parameter_templates_h
#define continua_program_parameter_templates_h

#include <ostream>
#include <string>
#include <vector>

namespace Continua
{
/**
 * A parameter file to begin with: one for each geometry and for each analysis. They are the files
 * of parameter_files/new, which the build puts into the program.
 */
struct ParameterTemplate
{
  std::string name;        ///< of the geometry or analysis, with spaces
  std::string description; ///< one sentence, the first comment of the file
  std::string text;        ///< the parameter file
  /// Names and texts of the files that it reads, such as a table.
  std::vector<std::pair<std::string, std::string>> files;
};

/// All of them, sorted by name.
const std::vector<ParameterTemplate> &parameter_templates();

/// Prints names and descriptions.
void print_templates(std::ostream &out);

/**
 * Prints the template `name` (spaces or hyphens), or the file `name` that a template reads. To
 * `notes` go the commands that print the files which the template reads. Throws InputError if there
 * is none.
 */
void print_template(const std::string &name, std::ostream &out, std::ostream &notes);

/**
 * Writes the template `name` to `file`, and the files that it reads beside it, named after `file`:
 * my.geo for my.prm. Returns what was written. Throws InputError if there is no such template, if
 * the folder does not exist, and if one of the files exists: then nothing is written.
 */
std::vector<std::string> write_template(const std::string &name, const std::string &file);
} // namespace Continua

#endif
