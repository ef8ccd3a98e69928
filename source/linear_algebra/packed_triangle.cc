#include <continua/linear_algebra/packed_triangle.h>

#include <algorithm>
#include <array>

namespace Continua
{
void PackedTriangle::reinit(const bool lower,
                            const std::vector<std::size_t> &starts,
                            const std::vector<int> &columns,
                            const std::vector<double> &values)
{
  this->lower = lower;
  const int n_rows = static_cast<int>(starts.size()) - 1;
  const int n_blocks = (n_rows + block - 1) / block;
  block_starts.assign(1, 0);
  block_columns.clear();
  block_values.clear();
  diagonal.assign(static_cast<std::size_t>(n_blocks) * block * block, 0.);

  std::vector<std::size_t> place(n_rows); // of a column in the present block
  for (int b = 0; b < n_blocks; ++b)
  {
    const int begin = b * block;
    const int end = std::min(begin + block, n_rows);
    std::array<std::array<double, block>, block> triangle{};
    for (int i = 0; i < block; ++i)
      triangle[i][i] = 1.;
    const auto on_diagonal = [&](const int column) { return column >= begin && column < end; };

    for (std::size_t k = starts[begin]; k < starts[end]; ++k)
      if (!on_diagonal(columns[k]))
        block_columns.push_back(columns[k]);
    const auto first = block_columns.begin() + static_cast<std::ptrdiff_t>(block_starts.back());
    std::sort(first, block_columns.end());
    block_columns.erase(std::unique(first, block_columns.end()), block_columns.end());
    for (std::size_t k = block_starts.back(); k < block_columns.size(); ++k)
      place[block_columns[k]] = k;
    block_starts.push_back(block_columns.size());
    block_values.resize(block_columns.size() * block, 0.);

    for (int i = begin; i < end; ++i)
      for (std::size_t k = starts[i]; k < starts[i + 1]; ++k)
        if (on_diagonal(columns[k]))
          triangle[i - begin][columns[k] - begin] = values[k];
        else
          block_values[place[columns[k]] * block + (i - begin)] = -values[k];

    double *const inverse = &diagonal[static_cast<std::size_t>(b) * block * block];
    for (int column = 0; column < block; ++column)
      for (int step = 0; step < block; ++step)
      {
        const int i = lower ? step : block - 1 - step;
        double sum = (i == column) ? 1. : 0.;
        for (int j = lower ? 0 : i + 1; j < (lower ? i : block); ++j)
          sum -= triangle[i][j] * inverse[column * block + j];
        inverse[column * block + i] = sum / triangle[i][i];
      }
  }
  block_columns.shrink_to_fit();
  block_values.shrink_to_fit();
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
    for (int i = 0; i < block; ++i)
      even[i] += value[i] * x_even;
    for (int i = 0; i < block; ++i)
      odd[i] += value[block + i] * x_odd;
  }
  if (column < end)
    for (int i = 0; i < block; ++i)
      even[i] += value[i] * x[*column];
  for (int i = 0; i < block; ++i)
    even[i] += odd[i];

  std::array<double, block> solution{};
  const double *const inverse = &diagonal[b * block * block];
  for (int j = 0; j < block; ++j)
    for (int i = 0; i < block; ++i)
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
