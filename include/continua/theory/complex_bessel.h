#ifndef continua_theory_complex_bessel_h
#define continua_theory_complex_bessel_h

#include <complex>

namespace Continua
{
using Complex = std::complex<double>;

/**
 * Bessel functions of integer order and complex argument, from Arb (F. Johansson, IEEE Trans.
 * Comput. 66, 2017), which bounds its own error: the working precision is raised until the
 * magnitude of the error is certified to be less than 1e-14 of the result's, which is then rounded.
 * Near a zero of a function its value is as exact as elsewhere, for the argument as it is
 * represented.
 *
 * Ratios are formed in Arb, whose exponents have no limit: numerator and denominator may be far
 * beyond the range of double (J_0(1000 i^1.5) is 1e305), only the ratio must be within it.
 *
 * All throw std::domain_error if an argument is not finite, if a denominator is 0, or if the result
 * is too large for double; std::runtime_error if the accuracy cannot be reached.
 */
/// J_n(z), of the first kind.
Complex bessel_j(unsigned int n, Complex z);

/// J_m(a) / J_n(b).
Complex bessel_j_ratio(unsigned int m, Complex a, unsigned int n, Complex b);
/// I_m(a) / I_n(b), modified.
Complex bessel_i_ratio(unsigned int m, Complex a, unsigned int n, Complex b);
} // namespace Continua

#endif
