// Least squares without negative values: the values of scipy, and the conditions of an optimum.

#include <continua/base/nonnegative_least_squares.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "../unit_test.h"

namespace test_of_nonnegative_least_squares
{
using namespace Continua;

namespace
{
void compare(const std::string &name,
             const NonnegativeLeastSquares &found,
             const std::vector<double> &values,
             const double residual_norm)
{
  for (std::size_t j = 0; j < values.size(); ++j)
    check::absolute(name + ": value " + std::to_string(j), found.values[j], values[j], 1e-9);
  check::relative(name + ": residual", found.residual_norm, residual_norm, 1e-12);
}
} // namespace

UNIT_TEST(nonnegative_least_squares)
{
  // The values of scripts/references/solids/nonnegative_least_squares.py (scipy.optimize.nnls).
  {
    std::vector<std::vector<double>> columns(6, std::vector<double>(9));
    std::vector<double> b(9);
    for (int i = 0; i < 9; ++i)
    {
      for (int j = 0; j < 6; ++j)
        columns[j][i] = (7 * i + 3 * j + i * j) % 11 - 4;
      b[i] = (5 * i + 2) % 13 - 5;
    }
    compare("whole numbers", nonnegative_least_squares(columns, b),
            {0.356925207756233, 0., 0., 0.104570637119114, 0., 0.}, 11.022509077845713);
    // Without a bound that holds it is the solution of the equations.
    std::vector<double> sum(9);
    for (int i = 0; i < 9; ++i)
      sum[i] = 2. * columns[0][i] + 0.5 * columns[4][i];
    const NonnegativeLeastSquares exact = nonnegative_least_squares(columns, sum);
    check::absolute("exact: first value", exact.values[0], 2., 1e-12);
    check::absolute("exact: fifth value", exact.values[4], 0.5, 1e-12);
    check::absolute("exact: residual", exact.residual_norm, 0., 1e-11);
    // Everything points away.
    for (double &entry : sum)
      entry = -entry;
    for (std::vector<double> &column : columns)
      for (double &entry : column)
        entry = std::abs(entry);
    for (double &entry : sum)
      entry = -std::abs(entry);
    const NonnegativeLeastSquares none = nonnegative_least_squares(columns, sum);
    for (std::size_t j = 0; j < 6; ++j)
      check::absolute("away: value " + std::to_string(j), none.values[j], 0., 0.);
  }
  {
    std::vector<std::vector<double>> columns(14, std::vector<double>(32, 1.));
    std::vector<double> b(32);
    for (int i = 0; i < 32; ++i)
    {
      const double time = 0.1 * std::pow(1.25, i);
      for (int k = 0; k < 13; ++k)
        columns[1 + k][i] = std::exp(-time / std::pow(10., -1. + 0.25 * k));
      b[i] =
          4. + 1.5 * std::exp(-time / 0.5) + 0.8 * std::exp(-time / 10.) + 0.02 * std::cos(5. * i);
    }
    compare("exponentials", nonnegative_least_squares(columns, b),
            {4.000612772715856, 0., 0., 0.359266411004686, 1.173175153840245, 0., 0., 0., 0.,
             0.781340062159762, 0.010370486522841, 0., 0., 0.},
            0.08029724002552083);
    // A column twice: the sum of both is what counts.
    columns.push_back(columns[4]);
    const NonnegativeLeastSquares twice = nonnegative_least_squares(columns, b);
    check::absolute("twice: sum of both", twice.values[4] + twice.values[14], 1.173175153840245,
                    1e-9);
  }
  check::throws<std::invalid_argument>(
      "a short column",
      []() {
        nonnegative_least_squares({{1., 2.}, {1.}}, {1., 1.});
      },
      "as long as");
}
} // namespace test_of_nonnegative_least_squares
