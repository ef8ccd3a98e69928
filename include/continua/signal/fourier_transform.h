#ifndef continua_signal_fourier_transform_h
#define continua_signal_fourier_transform_h

#include <complex>
#include <cstddef>
#include <vector>

namespace Continua
{
/**
 * The discrete Fourier transform of n real samples x_j by GSL (mixed radix: fastest where n has
 * small prime factors only, such as a power of two),
 *
 *   X_k = sum_j x_j exp(-2 pi i j k/n),   k = 0 ... n/2,
 *
 * the others being X_(n-k) = conj(X_k). The unit is that of the samples. Throws
 * std::invalid_argument if there is no sample.
 */
std::vector<std::complex<double>> fourier_transform(const std::vector<double> &samples);

/**
 * The n samples with this transform, x_j = 1/n sum_k X_k exp(2 pi i j k/n) over all k; what X_0
 * (and X_(n/2) for even n) has as an imaginary part does not count. Throws std::invalid_argument if
 * `spectrum` has not n/2 + 1 entries.
 */
std::vector<double> inverse_fourier_transform(const std::vector<std::complex<double>> &spectrum,
                                              std::size_t n_samples);

/// The smallest power of two that is not less than n.
std::size_t next_power_of_two(std::size_t n);
} // namespace Continua

#endif
