#ifndef continua_base_angle_entry_h
#define continua_base_angle_entry_h

#include <continua/base/parameter_section.h>

#include <string>

namespace Continua
{
/**
 * Declares and reads an angle [rad], which must have its unit, `deg` or `rad`: a number alone would
 * be taken for degrees by one reader and for radians by another. Zero needs none. `value`: the
 * default before. Throws InputError.
 */
void add_angle(ParameterSection section,
               const std::string &key,
               double &value,
               const std::string &text);
} // namespace Continua

#endif
