#ifndef continua_program_unknown_names_h
#define continua_program_unknown_names_h

#include <continua/base/parameter_file.h>

namespace Continua
{
/// Throws one InputError for all entries and sections of the file that no analysis, model or type
/// knows, one a line, each with the nearest name. ParameterFile::refuse_unknown() is stricter,
/// since it knows what this very case reads, but that is known only when nothing is missing.
void refuse_unknown_names(const ParameterFile &file);
} // namespace Continua

#endif
