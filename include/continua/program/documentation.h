#ifndef continua_program_documentation_h
#define continua_program_documentation_h

#include <continua/base/parameter_file.h>

#include <ostream>

namespace Continua
{
/**
 * Prints every entry that exists: the general sections, and each geometry, material and boundary
 * condition of the tables with its own entries. The parameter pages of the manual are made of it.
 */
void print_documentation(std::ostream &out, ParameterFile::Style style);
} // namespace Continua

#endif
