#ifndef continua_theory_constants_h
#define continua_theory_constants_h

#include <complex>

namespace Continua
{
constexpr double pi = 3.14159265358979323846;
/// The imaginary unit.
constexpr std::complex<double> imaginary(0., 1.);
} // namespace Continua

#endif
