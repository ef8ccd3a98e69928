#include <continua/linear_algebra/block_sums.h>

#include <algorithm>
#include <array>

// The loader chooses the form of a function for its processor. Only the GNU C library has such a
// loader, and the choice comes before a sanitizer is ready. CONTINUA_INSTRUCTIONS has no part in
// it.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && __GNUC__ >= 12 &&            \
    !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define CONTINUA_OF_PROCESSOR                                                                      \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define CONTINUA_OF_PROCESSOR
#endif

namespace Continua
{
CONTINUA_OF_PROCESSOR void add_up_rows(const double *const factors,
                                       const std::size_t n_rows,
                                       const double *const table,
                                       const std::size_t n,
                                       double *const __restrict values)
{
  std::fill_n(values, n, 0.);
  // Four rows at a time: fewer reads and writes of the sums. The inner loops have a constant
  // length: with -O2 the compiler takes no others into vector registers.
  std::size_t a = 0;
  for (; a + 4 <= n_rows; a += 4)
    for (std::size_t i = 0; i < n; i += sums_block)
    {
      const double *const row = table + a * n + i;
      for (std::size_t k = 0; k < sums_block; ++k)
        values[i + k] += factors[a] * row[k] + factors[a + 1] * row[n + k] +
                         factors[a + 2] * row[2 * n + k] + factors[a + 3] * row[3 * n + k];
    }
  for (; a < n_rows; ++a)
    for (std::size_t i = 0; i < n; i += sums_block)
      for (std::size_t k = 0; k < sums_block; ++k)
        values[i + k] += factors[a] * table[a * n + i + k];
}

CONTINUA_OF_PROCESSOR void multiply_rows(const double *const values,
                                         const std::size_t n_rows,
                                         const double *const table,
                                         const std::size_t n,
                                         double *const __restrict sums)
{
  for (std::size_t a = 0; a < n_rows; ++a)
  {
    std::array<double, sums_block> parts{};
    for (std::size_t i = 0; i < n; i += sums_block)
      for (std::size_t k = 0; k < sums_block; ++k)
        parts[k] += values[i + k] * table[a * n + i + k];
    sums[a] = ((parts[0] + parts[1]) + (parts[2] + parts[3])) +
              ((parts[4] + parts[5]) + (parts[6] + parts[7]));
  }
}
} // namespace Continua
