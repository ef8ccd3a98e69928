#ifndef continua_base_undefined_h
#define continua_base_undefined_h

#include <limits>

namespace Continua
{
/// The value of a quantity that there is none of.
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
} // namespace Continua

#endif
