#include "../unit_test.h"
#include "function_model.h"
#include "random_noise.h"
#include "records.h"

#include <continua/base/input_error.h>
#include <continua/inference/least_squares_fit.h>

#include <cmath>

namespace test_of_residual_noise
{
using namespace Continua;

namespace
{
using Values = std::vector<double>;

/// Two instruments measure one number, with noise that is ten times as large in one of them.
void test_two_records()
{
  RandomNoise random(11);
  Values good = random.white(200);
  Values bad = random.white(50);
  for (double &value : good)
    value = 5. + 0.1 * value;
  for (double &value : bad)
    value = 5. + value;
  FunctionModel model([](const Values &set) -> Values { return Values(250, set[0]); });
  FitOptions options;
  options.tolerance = 1e-9;
  options.correlated_noise = CorrelatedNoise::as_given;
  const FitResult result = LeastSquaresFit({parameter_of("number", 1.)},
                                           {uniform_record("good", 0., good, undefined),
                                            uniform_record("bad", 0., bad, undefined)},
                                           model, options)
                               .solve();
  // The equations of weighted means, iterated here: s_r^2 = sum of squares / (n_r - its weight).
  double mean = 0.;
  double s_good = 1.;
  double s_bad = 1.;
  for (int k = 0; k < 200; ++k)
  {
    const double w_good = 200. / s_good;
    const double w_bad = 50. / s_bad;
    double sum_good = 0.;
    double sum_bad = 0.;
    for (const double value : good)
      sum_good += value;
    for (const double value : bad)
      sum_bad += value;
    mean = (sum_good / s_good + sum_bad / s_bad) / (w_good + w_bad);
    double square_good = 0.;
    double square_bad = 0.;
    for (const double value : good)
      square_good += std::pow(value - mean, 2);
    for (const double value : bad)
      square_bad += std::pow(value - mean, 2);
    s_good = square_good / (200. - w_good / (w_good + w_bad));
    s_bad = square_bad / (50. - w_bad / (w_good + w_bad));
  }
  check::relative("number", result.estimates[0], mean, 1e-7);
  check::relative("good noise", result.records[0].noise.standard_deviation, std::sqrt(s_good),
                  1e-4);
  check::relative("bad noise", result.records[1].noise.standard_deviation, std::sqrt(s_bad), 1e-4);
  check::relative("error", result.standard_errors[0], 1. / std::sqrt(200. / s_good + 50. / s_bad),
                  1e-4);
  check::relative("degrees of freedom", result.degrees_of_freedom, 249., 0.);
}

void test_odd_records()
{
  FunctionModel model([](const Values &set) -> Values { return {set[0], set[0], set[0], set[1]}; });
  const std::vector<FitParameter> parameters{parameter_of("a", 1.), parameter_of("b", 1.)};
  check::throws<RunError>(
      "one value and its noise",
      [&]()
      {
        LeastSquaresFit(parameters,
                        {uniform_record("three", 0., {1., 2., 3.}, 1.),
                         uniform_record("one", 0., {1.}, undefined)},
                        model)
            .solve();
      },
      "'one' has too few values to tell its noise");
  const FitResult exact =
      LeastSquaresFit(parameters, {uniform_record("exact", 1., {2., 2., 2., 5.}, undefined)}, model)
          .solve();
  check::relative("data without noise", exact.estimates[1], 5., 1e-9);
  check::is_true("no noise is left", exact.records[0].noise.standard_deviation < 1e-9);

  // Correlation is looked for only where values have an order and none was given.
  const Values noise = RandomNoise(12).autoregressive({0.8}, 100);
  FunctionModel mean([](const Values &set) -> Values { return Values(100, set[0]); });
  const auto order = [&](const DataRecord &record)
  {
    return LeastSquaresFit({parameter_of("m", 1.)}, {record}, mean)
        .solve()
        .records[0]
        .n_fitted_coefficients;
  };
  check::is_true("ordered", order(uniform_record("y", 0.1, noise, undefined)) >= 1);
  check::is_true("not ordered", order(uniform_record("y", 0., noise, undefined)) == 0);
  DataRecord given = uniform_record("y", 0.1, noise, undefined);
  given.noise.correlation_time = 0.5;
  check::is_true("given", order(given) == 0);
}
} // namespace

UNIT_TEST(residual_noise)
{
  test_two_records();
  test_odd_records();
}
} // namespace test_of_residual_noise
