#ifndef continua_base_required_entry_h
#define continua_base_required_entry_h

#include <continua/base/parameter_section.h>

#include <string>

namespace Continua
{
/// Declares a quantity that has no sensible default, and reads it. `text` gets "Required." behind
/// it. Throws InputError if it is missing or out of range.
double required_entry(ParameterSection &section,
                      const std::string &key,
                      const Dimension &dimension,
                      const std::string &text,
                      const Range &range);
} // namespace Continua

#endif
