#ifndef continua_program_unknown_names_h
#define continua_program_unknown_names_h

#include <continua/base/input_error.h>
#include <continua/base/parameter_file.h>

namespace Continua
{
/**
 * Throws InputError for all names in the file that no analysis knows, one a line, each with the
 * nearest name. For a file that cannot be read further by reason of `error`, so that what its
 * types would declare is not known. Does nothing if `error` is about one of these names itself.
 */
void refuse_unknown_names(const ParameterFile &file, const InputError &error);
} // namespace Continua

#endif
