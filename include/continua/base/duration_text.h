#ifndef continua_base_duration_text_h
#define continua_base_duration_text_h

#include <string>

namespace Continua
{
/// "1 h 02 min", "3 min 20 s", "12 s".
std::string duration_text(double seconds);
} // namespace Continua

#endif
