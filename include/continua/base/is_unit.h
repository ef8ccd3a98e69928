#ifndef continua_base_is_unit_h
#define continua_base_is_unit_h

#include <string>

namespace Continua
{
/// Whether `text` is a unit of any dimension ("mm", "kg/m^3"), and not any words.
bool is_unit(const std::string &text);
} // namespace Continua

#endif
