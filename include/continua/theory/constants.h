#ifndef continua_theory_constants_h
#define continua_theory_constants_h

#include <complex>

namespace Continua
{
/// The imaginary unit.
constexpr std::complex<double> imaginary(0., 1.);
} // namespace Continua

#endif
