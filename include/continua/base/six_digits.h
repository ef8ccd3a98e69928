#ifndef continua_base_six_digits_h
#define continua_base_six_digits_h

#include <string>

namespace Continua
{
/// A computed value in a message: as many digits as a reader takes in.
std::string six_digits(double value);
} // namespace Continua

#endif
