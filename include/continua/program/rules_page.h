#ifndef continua_program_rules_page_h
#define continua_program_rules_page_h

#include <continua/base/parameter_file.h>

#include <ostream>

namespace Continua
{
/**
 * Prints the features that an input can have, and the rules that say which of them go together: the
 * page "What goes with what" of the manual (markdown), or the same for programs (json). In json,
 * "apart" has the pairs of which no file can have both, since they are values of one entry, or one
 * belongs to a section that the other, an analysis, does not read.
 */
void print_rules(std::ostream &out, ParameterFile::Style style);
} // namespace Continua

#endif
