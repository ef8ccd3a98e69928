#ifndef continua_signal_linear_recurrence_h
#define continua_signal_linear_recurrence_h

#include <complex>
#include <vector>

namespace Continua
{
/// The complex roots of c[0] + c[1] z + ... + c[n] z^n, the largest magnitude first; of two that
/// are conjugate that in the upper half plane first. c[n] is not zero. Throws
/// std::runtime_error where they cannot be found.
std::vector<std::complex<double>> polynomial_roots(const std::vector<double> &coefficients);

/// The numbers G_j of a sequence a_k = sum_j b_j G_j^k, sorted as the roots of a polynomial: the
/// method of G. de Prony (J. Ecole Polytechnique 1, 1795). `order`: how many they are; the sequence
/// has at least twice as many members, of which the first count, and all b_j are different from
/// zero. Throws std::invalid_argument for a sequence that is shorter or has fewer numbers.
std::vector<std::complex<double>> recurrence_factors(const std::vector<double> &sequence,
                                                     unsigned int order);
} // namespace Continua

#endif
