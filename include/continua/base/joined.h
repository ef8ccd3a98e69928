#ifndef continua_base_joined_h
#define continua_base_joined_h

#include <string>
#include <vector>

namespace Continua
{
/// "a, b, c".
std::string joined(const std::vector<std::string> &words);
} // namespace Continua

#endif
