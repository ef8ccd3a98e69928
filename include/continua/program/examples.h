#ifndef continua_program_examples_h
#define continua_program_examples_h

#include <ostream>
#include <string>

namespace Continua
{
/**
 * The folder of the parameter files that came with the program: `share/continua/parameter_files` of
 * the prefix in which the program is installed, or `parameter_files` of the checkout in which it
 * was built. Throws InputError if there is neither.
 */
std::string examples_folder();

/// Lists the parameter files of the folder and its subfolders, each with the first sentence
/// of its comment. Pieces that several files include (`common`) are left out.
void print_examples(std::ostream &out, const std::string &folder);
} // namespace Continua

#endif
