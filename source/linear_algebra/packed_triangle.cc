#include <continua/linear_algebra/packed_triangle.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace Continua
{
void PackedTriangle::begin(const bool is_lower,
                           const std::size_t n_rows,
                           const std::vector<std::size_t> &n_columns)
{
  lower = is_lower;
  block_starts.assign(n_columns.size() + 1, 0);
  std::partial_sum(n_columns.begin(), n_columns.end(), block_starts.begin() + 1);
  block_columns = std::vector<int>(block_starts.back());
  block_values = std::vector<double>(block_starts.back() * block, 0.);
  diagonal.assign(n_columns.size() * block * block, 0.);
  // Beyond the last row.
  for (std::size_t i = n_rows; i < n_columns.size() * block; ++i)
    diagonal[i * block + i % block] = 1.;
}

void PackedTriangle::take_lower_by_rows(const std::vector<std::int64_t> &starts,
                                        const std::vector<std::int64_t> &indices,
                                        const std::vector<double> &values)
{
  const std::size_t n_rows = starts.size() - 1, n_blocks = (n_rows + block - 1) / block;
  // `take(b, row, k)` for each entry, with the block of its row.
  const auto visit_block = [&](const std::size_t b, const auto &take)
  {
    for (std::size_t row = b * block; row < std::min((b + 1) * block, n_rows); ++row)
      for (std::int64_t k = starts[row]; k < starts[row + 1]; ++k)
        take(row, static_cast<std::size_t>(indices[k]), values[k]);
  };
  // Of a column: the last block that has it, from 1 on, and the place of it there.
  std::vector<std::size_t> last_block(n_rows, 0), place(n_rows);
  std::vector<std::size_t> n_columns(n_blocks, 0);
  for (std::size_t b = 0; b < n_blocks; ++b)
    visit_block(b,
                [&](std::size_t, const std::size_t column, double)
                {
                  if (column < b * block && last_block[column] != b + 1)
                  {
                    last_block[column] = b + 1;
                    ++n_columns[b];
                  }
                });
  begin(true, n_rows, n_columns);
  std::fill(last_block.begin(), last_block.end(), 0);
  for (std::size_t b = 0; b < n_blocks; ++b)
  {
    int *const columns = block_columns.data() + block_starts[b];
    int *end = columns;
    visit_block(b,
                [&](std::size_t, const std::size_t column, double)
                {
                  if (column < b * block && last_block[column] != b + 1)
                  {
                    last_block[column] = b + 1;
                    *end++ = static_cast<int>(column);
                  }
                });
    std::sort(columns, end);
    for (const int *column = columns; column < end; ++column)
      place[*column] = column - block_columns.data();
    visit_block(b,
                [&](const std::size_t row, const std::size_t column, const double value)
                {
                  if (column < b * block)
                    block_values[place[column] * block + row % block] = -value;
                  else
                    diagonal[(b * block + column % block) * block + row % block] = value;
                });
  }
  invert_diagonal();
}

void PackedTriangle::take_upper_by_columns(const std::vector<std::int64_t> &starts,
                                           const std::vector<std::int64_t> &indices,
                                           const std::vector<double> &values)
{
  const std::size_t n_rows = starts.size() - 1, n_blocks = (n_rows + block - 1) / block;
  // Columns come one after the other, so that each block gets them in their order.
  std::vector<std::size_t> next(n_blocks, 0), last_column(n_blocks, n_rows);
  for (std::size_t column = 0; column < n_rows; ++column)
    for (std::int64_t k = starts[column]; k < starts[column + 1]; ++k)
      if (const std::size_t b = indices[k] / block; b != column / block && last_column[b] != column)
      {
        last_column[b] = column;
        ++next[b];
      }
  begin(false, n_rows, next);
  std::copy(block_starts.begin(), block_starts.end() - 1, next.begin());
  std::fill(last_column.begin(), last_column.end(), n_rows);
  for (std::size_t column = 0; column < n_rows; ++column)
    for (std::int64_t k = starts[column]; k < starts[column + 1]; ++k)
    {
      const std::size_t row = indices[k], b = row / block;
      if (b == column / block)
      {
        diagonal[column * block + row % block] = values[k];
        continue;
      }
      if (last_column[b] != column)
      {
        last_column[b] = column;
        block_columns[next[b]++] = static_cast<int>(column);
      }
      block_values[(next[b] - 1) * block + row % block] = -values[k];
    }
  invert_diagonal();
}

void PackedTriangle::invert_diagonal()
{
  std::array<double, block * block> triangle{}; // by columns
  for (std::size_t b = 0; b + 1 < block_starts.size(); ++b)
  {
    double *const inverse = &diagonal[b * block * block];
    std::copy_n(inverse, block * block, triangle.begin());
    for (std::size_t column = 0; column < block; ++column)
      for (std::size_t step = 0; step < block; ++step)
      {
        const std::size_t i = lower ? step : block - 1 - step;
        double sum = (i == column) ? 1. : 0.;
        for (std::size_t j = lower ? 0 : i + 1; j < (lower ? i : block); ++j)
          sum -= triangle[j * block + i] * inverse[column * block + j];
        inverse[column * block + i] = sum / triangle[i * block + i];
      }
  }
}

inline void PackedTriangle::solve_block(const std::size_t b, double *const x) const
{
  const double *value = block_values.data() + block_starts[b] * block; // a diagonal matrix has none
  const int *column = block_columns.data() + block_starts[b];
  const int *const end = block_columns.data() + block_starts[b + 1];
  // Two columns at a time: two chains of additions that do not wait for each other.
  std::array<double, block> even, odd{};
  std::copy_n(x + b * block, block, even.begin());
  for (; end - column > 1; column += 2, value += 2 * block)
  {
    const double x_even = x[column[0]];
    const double x_odd = x[column[1]];
    for (std::size_t i = 0; i < block; ++i)
      even[i] += value[i] * x_even;
    for (std::size_t i = 0; i < block; ++i)
      odd[i] += value[block + i] * x_odd;
  }
  if (column < end)
    for (std::size_t i = 0; i < block; ++i)
      even[i] += value[i] * x[*column];
  for (std::size_t i = 0; i < block; ++i)
    even[i] += odd[i];

  std::array<double, block> solution{};
  const double *const inverse = &diagonal[b * block * block];
  for (std::size_t j = 0; j < block; ++j)
    for (std::size_t i = 0; i < block; ++i)
      solution[i] += inverse[j * block + i] * even[j];
  std::copy_n(solution.begin(), block, x + b * block);
}

void PackedTriangle::solve(double *const x) const
{
  const std::size_t n_blocks = block_starts.empty() ? 0 : block_starts.size() - 1;
  if (lower)
    for (std::size_t b = 0; b < n_blocks; ++b)
      solve_block(b, x);
  else
    for (std::size_t b = n_blocks; b > 0; --b)
      solve_block(b - 1, x);
}

double PackedTriangle::memory() const
{
  return static_cast<double>(sizeof(std::size_t) * block_starts.size() +
                             sizeof(int) * block_columns.size() +
                             sizeof(double) * (block_values.size() + diagonal.size()));
}
} // namespace Continua
