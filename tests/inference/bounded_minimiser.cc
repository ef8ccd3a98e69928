#include "../unit_test.h"
#include "function_model.h"
#include "random_noise.h"
#include "records.h"

#include <continua/inference/least_squares_fit.h>

#include <cmath>

namespace test_of_bounded_minimiser
{
using namespace Continua;

namespace
{
using Values = std::vector<double>;

/// y = a + b x at x = 0, 1, 2, 3 with noise 1.
FunctionModel line()
{
  return FunctionModel(
      [](const Values &set) -> Values {
        return {set[0], set[0] + set[1], set[0] + 2. * set[1], set[0] + 3. * set[1]};
      });
}

FitOptions accurate()
{
  FitOptions options;
  options.tolerance = 1e-9;
  return options;
}

void test_bound()
{
  FunctionModel model = line();
  // Free: a = 1.5, b = -0.2. With b >= 0: b = 0, a = mean 1.2.
  const DataRecord record = uniform_record("y", 1., {1.4, 1.5, 1., 0.9}, 1.);
  const auto parameters = [](const double start) {
    return std::vector<FitParameter>{parameter_of("a", 1.), bounded_parameter("b", start, 0., 5.)};
  };
  for (const double start : {2., 0., 5.})
  {
    const FitResult result =
        LeastSquaresFit(parameters(start), {record}, model, accurate()).solve();
    const std::string name = "start " + std::to_string(static_cast<int>(start)) + ": ";
    check::is_true(name + "at the bound",
                   result.converged && result.at_bound[1] && result.estimates[1] == 0.);
    check::relative(name + "the other one", result.estimates[0], 1.2, 1e-8);
    check::is_true(name + "no error at the bound",
                   std::isnan(result.standard_errors[1]) && result.free.size() == 1);
    check::relative(name + "error of the other one", result.standard_errors[0], 0.5, 1e-8);
    // Slope of the free line: sum (x - 1.5)(y - 1.2) / 5 = -0.2, its error 1/sqrt(5); one-sided
    // quantile 1.644853627.
    const double reach = -0.2 + std::sqrt(0.04 + 1.6448536269514722 * 1.6448536269514722 / 5.);
    check::relative(name + "one-sided interval", result.intervals[1].upper, reach, 1e-6);
    check::is_true(name + "ends at the bound", result.intervals[1].lower == 0. &&
                                                   result.intervals[1].lower_is_bound &&
                                                   !result.intervals[1].upper_is_bound);
    check::is_true(name + "note", check::matches(result.notes.front(), "'b' is at its bound 0 1"));
  }
  // The same at an upper bound.
  const FitResult upper =
      LeastSquaresFit({parameter_of("a", 1.), bounded_parameter("b", -2., -5., -0.3)}, {record},
                      model, accurate())
          .solve();
  check::is_true("upper bound", upper.at_bound[1] && upper.estimates[1] == -0.3 &&
                                    upper.intervals[1].upper_is_bound);
  check::relative("interval below it", upper.intervals[1].lower,
                  -0.3 + 0.1 - std::sqrt(0.01 + 1.6448536269514722 * 1.6448536269514722 / 5.),
                  1e-6);
}

/// Enlarging reaches the interval of a parameter at its bound, too.
void test_enlarged_at_bound()
{
  std::vector<double> values = RandomNoise(31).autoregressive({0.7}, 300);
  double mean = 0.;
  for (double &value : values)
  {
    value -= 0.3;
    mean += value / values.size();
  }
  FunctionModel model([](const Values &set) -> Values { return Values(300, set[0]); });
  FitOptions options = accurate();
  options.correlated_noise = CorrelatedNoise::enlarged;
  const FitResult result = LeastSquaresFit({bounded_parameter("level", 1., 0., 5.)},
                                           {uniform_record("y", 1., values, 1.4)}, model, options)
                               .solve();
  check::is_true("level at its bound", mean < 0. && result.at_bound[0]);
  const double ratio =
      fit_autoregressive_model_of_best_order(values, options.order_criterion, false)
          .largest_spectral_ratio();
  check::relative("ratio", result.treated_over_plain_variance[0], ratio, 1e-10);
  const double q = 1.6448536269514722;
  check::relative("enlarged one-sided interval", result.intervals[0].upper,
                  mean + std::sqrt(mean * mean + q * q * ratio * 1.4 * 1.4 / 300.), 1e-8);
}

/// A valley that touches a bound on its way to the least value, which lies inside.
void test_release()
{
  FunctionModel valley(
      [](const Values &set) -> Values {
        return {10. * (set[1] - set[0] * set[0]), 1. - set[0]};
      });
  DataRecord record = uniform_record("y", 0., {0., 0.}, 1.);
  record.times = {0., 1.};
  for (const TrustRegion trust_region :
       {TrustRegion::levenberg_marquardt, TrustRegion::geodesic_acceleration, TrustRegion::dogleg})
  {
    FitOptions options = accurate();
    options.trust_region = trust_region;
    const FitResult result = LeastSquaresFit({bounded_parameter("x", -1.2, -1.5, 1.05),
                                              bounded_parameter("y", 1., 0., 1.2)},
                                             {record}, valley, options)
                                 .solve();
    check::is_true("inside in the end",
                   result.converged && !result.at_bound[0] && !result.at_bound[1]);
    check::absolute("Rosenbrock",
                    std::abs(result.estimates[0] - 1.) + std::abs(result.estimates[1] - 1.), 0.,
                    1e-6);
  }
}

void test_stops()
{
  FunctionModel model = line();
  const DataRecord record = uniform_record("y", 1., {1.4, 1.5, 1., 0.9}, 1.);
  FitOptions options = accurate();
  options.largest_n_evaluations = 3;
  const FitResult few =
      LeastSquaresFit({parameter_of("a", 100.), parameter_of("b", 100.)}, {record}, model, options)
          .solve();
  check::is_true("too few evaluations",
                 !few.converged && check::matches(few.stop_reason, "evaluations, 3, is reached"));
  const FitResult all =
      LeastSquaresFit({bounded_parameter("a", 3., 2., 4.), bounded_parameter("b", 1., 0.5, 5.)},
                      {record}, model, accurate())
          .solve();
  check::is_true("all at bounds", all.converged && all.estimates[0] == 2. &&
                                      all.estimates[1] == 0.5 && all.free.empty());
  check::is_true("ends of their intervals",
                 all.intervals[0].lower == 2. && all.intervals[0].upper > 2. &&
                     all.intervals[1].upper > 0.5 && std::isnan(all.standard_errors[0]));
  check::equal("reason", all.stop_reason, "all parameters are at a bound");
}
} // namespace

UNIT_TEST(bounded_minimiser)
{
  test_bound();
  test_enlarged_at_bound();
  test_release();
  test_stops();
}
} // namespace test_of_bounded_minimiser
