// Sums of small tables, beside the same sums in a plain loop.

#include <continua/linear_algebra/block_sums.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "../unit_test.h"

namespace test_of_block_sums
{
using namespace Continua;

UNIT_TEST(block_sums)
{
  double of_rows = 0., of_columns = 0.;
  for (const std::size_t n_rows : {1, 3, 4, 9, 16, 27})
    for (const std::size_t n : {8, 24, 256})
    {
      std::vector<double> table(n_rows * n), factors(n_rows), values(n);
      for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = std::sin(1. + i);
      for (std::size_t a = 0; a < n_rows; ++a)
        factors[a] = std::cos(3. * a);
      for (std::size_t i = 0; i < n; ++i)
        values[i] = std::cos(2. + 5. * i);
      // What was there is overwritten.
      std::vector<double> sums_of_rows(n, 7.), sums_of_columns(n_rows, 7.);
      add_up_rows(factors.data(), n_rows, table.data(), n, sums_of_rows.data());
      multiply_rows(values.data(), n_rows, table.data(), n, sums_of_columns.data());
      for (std::size_t i = 0; i < n; ++i)
      {
        double sum = 0.;
        for (std::size_t a = 0; a < n_rows; ++a)
          sum += factors[a] * table[a * n + i];
        of_rows = std::max(of_rows, std::abs(sum - sums_of_rows[i]));
      }
      for (std::size_t a = 0; a < n_rows; ++a)
      {
        double sum = 0.;
        for (std::size_t i = 0; i < n; ++i)
          sum += table[a * n + i] * values[i];
        of_columns = std::max(of_columns, std::abs(sum - sums_of_columns[a]));
      }
    }
  check::absolute("sums of rows", of_rows, 0., 1e-13);
  check::absolute("sums of columns", of_columns, 0., 1e-13);
}
} // namespace test_of_block_sums
