#include <continua/network/solve_rows.h>

#include <cmath>
#include <utility>

namespace Continua
{
bool solve_rows(Rows &rows, std::vector<double> &solution)
{
  // Few entries of the matrix of a network are not zero.
  const std::size_t n = rows.size();
  for (std::vector<double> &row : rows)
  {
    double largest = 0.;
    for (std::size_t j = 0; j < n; ++j)
      largest = std::fmax(largest, std::abs(row[j]));
    for (double &value : row)
      value /= largest;
  }
  for (std::size_t k = 0; k < n; ++k)
  {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(rows[i][k]) > std::abs(rows[pivot][k]))
        pivot = i;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = k + 1; i < n; ++i)
      if (rows[i][k] != 0.)
      {
        const double factor = rows[i][k] / rows[k][k];
        for (std::size_t j = k; j <= n; ++j)
          rows[i][j] -= factor * rows[k][j];
      }
  }
  solution.resize(n);
  for (std::size_t k = n; k-- > 0;)
  {
    double sum = rows[k][n];
    for (std::size_t j = k + 1; j < n; ++j)
      sum -= rows[k][j] * solution[j];
    solution[k] = sum / rows[k][k];
    if (!std::isfinite(solution[k]))
      return false;
  }
  return true;
}
} // namespace Continua
