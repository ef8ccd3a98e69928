#ifndef continua_linear_algebra_block_sums_h
#define continua_linear_algebra_block_sums_h

#include <cstddef>

namespace Continua
{
/**
 * Sums of small tables, of which each row has a multiple of this many numbers: BLAS would spend
 * more on its own calls. They are compiled for processors with AVX2 and with AVX-512 besides the
 * baseline, and the program takes what its processor has: the last digits may be others there.
 */
constexpr std::size_t sums_block = 8;

/// values_i = sum_a factors_a table_ai, with n numbers in each of n_rows rows.
void add_up_rows(
    const double *factors, std::size_t n_rows, const double *table, std::size_t n, double *values);
/// sums_a = sum_i table_ai values_i.
void multiply_rows(
    const double *values, std::size_t n_rows, const double *table, std::size_t n, double *sums);
} // namespace Continua

#endif
