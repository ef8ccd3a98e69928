// Solves with factors L D L^T whose products with a vector are known: chains of columns of one
// pattern, columns alone, and a panel that takes zeros in.

#include <continua/linear_algebra/factor_panels.h>

#include "../unit_test.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace test_of_factor_panels
{
namespace
{
using Continua::FactorPanels;

/// Compressed columns.
struct Factor
{
  std::vector<int> starts, counts, rows;
  std::vector<double> values;
};

/// Of a matrix with these rows below the diagonal in each column, filled in as a factor of that
/// matrix is: what a column has below its parent, the parent has, too.
Factor factor_of(std::vector<std::set<int>> below)
{
  Factor factor;
  const int n = static_cast<int>(below.size());
  for (int column = 0; column < n; ++column)
  {
    if (!below[column].empty())
    {
      std::set<int> rest = below[column];
      const int parent = *rest.begin();
      rest.erase(rest.begin());
      below[parent].insert(rest.begin(), rest.end());
    }
    factor.starts.push_back(static_cast<int>(factor.rows.size()));
    factor.counts.push_back(1 + static_cast<int>(below[column].size()));
    factor.rows.push_back(column);
    factor.values.push_back(column % 3 == 1 ? -2. - 0.1 * column : 1.5 + 0.1 * column);
    for (const int row : below[column])
    {
      factor.rows.push_back(row);
      factor.values.push_back(0.3 * std::sin(1. + 3. * row + 7. * column));
    }
  }
  return factor;
}

/// L D L^T x.
std::vector<double> product(const Factor &factor, const std::vector<double> &x)
{
  const int n = static_cast<int>(x.size());
  std::vector<double> result(n, 0.);
  for (int column = 0; column < n; ++column)
  {
    const int begin = factor.starts[column], end = begin + factor.counts[column];
    double sum = x[column];
    for (int k = begin + 1; k < end; ++k)
      sum += factor.values[k] * x[factor.rows[k]];
    sum *= factor.values[begin];
    result[column] += sum;
    for (int k = begin + 1; k < end; ++k)
      result[factor.rows[k]] += factor.values[k] * sum;
  }
  return result;
}

/// Each column has all rows below it.
std::vector<std::set<int>> dense(const int n)
{
  std::vector<std::set<int>> below(n);
  for (int column = 0; column < n; ++column)
    for (int row = column + 1; row < n; ++row)
      below[column].insert(row);
  return below;
}

void check_solve(const std::string &name,
                 const std::vector<std::set<int>> &below,
                 const unsigned int n_panels)
{
  const Factor factor = factor_of(below);
  const int n = static_cast<int>(below.size());
  const FactorPanels panels(n, factor.starts.data(), factor.counts.data(), factor.rows.data(),
                            factor.values.data());
  std::vector<double> exact(n);
  for (int i = 0; i < n; ++i)
    exact[i] = 1. + 0.5 * std::cos(2. * i);
  std::vector<double> x = product(factor, exact);
  x.push_back(-7.); // room that the solve needs
  panels.solve(x.data());
  double error = 0.;
  for (int i = 0; i < n; ++i)
    error = std::max(error, std::abs(x[i] - exact[i]));
  check::absolute(name, error, 0., 1e-12);
  check::absolute(name + ": panels", panels.n_panels(), n_panels, 0.);
}
} // namespace

UNIT_TEST(factor_panels)
{
  check_solve("a diagonal", std::vector<std::set<int>>(5), 5);
  // A panel has at most 16 columns.
  for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 37})
    check_solve(std::to_string(n) + " dense columns", dense(n), (n + 15) / 16);
  // Columns 0 and 1 have the same rows below, 2 has one more, which they take in as zeros; 3 and 4
  // stand alone, and the others are dense.
  check_solve("branches",
              {{1, 2, 5, 6, 7, 8},
               {2, 5, 6, 7, 8},
               {5, 6, 7, 8, 9},
               {6, 9},
               {},
               {6, 7, 8, 9},
               {7, 8, 9},
               {8, 9},
               {9},
               {}},
              4);
  // Three columns of a band have a fifth of zeros, and four would have more.
  std::vector<std::set<int>> band = dense(12);
  for (int column = 0; column < 12; ++column)
    band[column].erase(band[column].lower_bound(column + 5), band[column].end());
  check_solve("a band", band, 3);
}
} // namespace test_of_factor_panels
