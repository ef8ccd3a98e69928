#include "../unit_test.h"

#include <continua/inference/least_squares_factor.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace test_of_least_squares_factor
{
using namespace Continua;

UNIT_TEST(least_squares_factor)
{
  // A straight line at 0, 1, 2, 4: n = 4, sum x = 7, sum x^2 = 21, determinant 35.
  const std::vector<double> x{0., 1., 2., 4.};
  const LeastSquaresFactor line({{1., 1., 1., 1.}, x});
  const auto inverse = line.inverse_of_normal_matrix();
  check::relative("variance of the intercept", inverse(0, 0), 21. / 35., 1e-13);
  check::relative("covariance", inverse(0, 1), -7. / 35., 1e-13);
  check::relative("variance of the slope", inverse(1, 1), 4. / 35., 1e-13);
  check::relative("determinant", line.log_determinant(), std::log(35.), 1e-13);
  check::relative("leverage of the last point", line.leverages()[3], 0.25 + 2.25 * 2.25 / 8.75,
                  1e-13);
  const std::vector<double> leverages = line.leverages();
  check::relative("sum of the leverages", std::accumulate(leverages.begin(), leverages.end(), 0.),
                  2., 1e-13);
  const std::vector<double> solution = line.solve({1., 3., 5., 9.});
  check::relative("solution", solution[0] + 10. * solution[1], 21., 1e-12);
  check::relative("length of what is in the range", line.length_in_range({1., 3., 5., 9.}),
                  std::sqrt(116.), 1e-13);
  check::absolute("length of what is not", line.length_in_range({2., -3., 0., 1.}),
                  std::sqrt(4. / 35.), 1e-12);
  const auto few = line.short_columns();
  check::relative("short columns", few[0][0] * few[1][0] + few[0][1] * few[1][1], 7., 1e-13);

  // The third column is twice the second: neither is seen, the first one is.
  const LeastSquaresFactor twice({{1., 0., 0., 0.}, {0., 1., 1., 0.}, {0., 2., 2., 0.}});
  const auto unseen = twice.inverse_of_normal_matrix();
  check::is_true("rank", twice.rank() == 2);
  check::relative("what is seen", unseen(0, 0), 1., 1e-12);
  check::is_true("what is not seen", std::isinf(unseen(1, 1)) && std::isinf(unseen(2, 2)));
  check::is_true("no determinant", std::isinf(twice.log_determinant()));
  const std::vector<double> shortest = twice.solve({3., 4., 4., 0.});
  check::relative("shortest solution", shortest[1] + 2. * shortest[2], 4., 1e-12);
  const LeastSquaresFactor nothing({{1., 1.}, {0., 0.}});
  check::is_true("column of zeros", std::isinf(nothing.inverse_of_normal_matrix()(1, 1)));
  check::relative("beside one of zeros", nothing.inverse_of_normal_matrix()(0, 0), 0.5, 1e-13);
  check::throws<std::invalid_argument>(
      "more columns than rows",
      []() {
        LeastSquaresFactor({{1.}, {2.}});
      },
      "as many rows");
}
} // namespace test_of_least_squares_factor
