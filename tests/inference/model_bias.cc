#include "../unit_test.h"
#include "function_model.h"
#include "records.h"

#include <continua/inference/least_squares_fit.h>
#include <continua/inference/model_bias.h>

#include <cmath>
#include <stdexcept>

namespace test_of_model_bias
{
using namespace Continua;

namespace
{
using Values = std::vector<double>;

/// A decay measured with 1 % of its start, and nature has a small second decay.
Values decay(const Values &set, const double second)
{
  Values values;
  for (int i = 0; i <= 20; ++i)
  {
    const double t = 0.1 * i;
    values.push_back(set[0] * std::exp(-set[1] * t) + second * t * std::exp(-3. * t));
  }
  return values;
}
} // namespace

UNIT_TEST(model_bias)
{
  // A straight line for data 1 + 2 x + 0.1 x^2 at 0 ... 4: by the normal equations the parabola
  // adds 0.4 to the slope and -0.2 to the intercept.
  FunctionModel line(
      [](const Values &set) -> Values
      {
        return {set[0], set[0] + set[1], set[0] + 2. * set[1], set[0] + 3. * set[1],
                set[0] + 4. * set[1]};
      });
  const Values truth{1., 3.1, 5.4, 7.9, 10.6};
  const std::vector<FitParameter> parameters{parameter_of("a", 1.), parameter_of("b", 1.)};
  const std::vector<DataRecord> records{uniform_record("y", 0., truth, 0.1)};
  FitOptions options;
  options.tolerance = 1e-9;
  const FitResult fit = LeastSquaresFit(parameters, records, line, options).solve();
  const Values model = fit.records[0].prediction;
  Values other = model;
  for (std::size_t i = 0; i < other.size(); ++i)
    other[i] += 0.1 * i * i;
  const ModelBias bias = model_bias(parameters, fit, records, model, other);
  check::relative("slope", bias.bias[1], 0.4, 1e-9);
  check::relative("intercept", bias.bias[0], -0.2, 1e-9);
  check::relative("over the standard error", bias.over_standard_error[1],
                  0.4 / (0.1 / std::sqrt(10.)), 1e-9);
  check::relative("is what the fit is off", fit.estimates[1] - 2., bias.bias[1], 1e-8);
  // 0.1 x^2 less the line: 0.2, -0.1, -0.2, -0.1, 0.2.
  check::relative("unexplained", bias.unexplained, std::sqrt(0.14) / 0.1, 1e-9);

  // Nonlinear, on a logarithmic scale, with a held parameter: predicted by first order.
  FunctionModel exponential([](const Values &set) -> Values { return decay(set, 0.); });
  std::vector<FitParameter> rates{parameter_of("amplitude", 1.3, FitParameter::Scale::logarithmic),
                                  parameter_of("rate", 1., FitParameter::Scale::logarithmic),
                                  held_parameter("other", 0.)};
  const Values true_set{1., 1.5, 0.};
  const std::vector<DataRecord> decays{uniform_record("y", 0., decay(true_set, 0.05), 0.01)};
  const FitResult of_decay = LeastSquaresFit(rates, decays, exponential, options).solve();
  const ModelBias of_rates = model_bias(rates, of_decay, decays, decay(of_decay.estimates, 0.),
                                        decay(of_decay.estimates, 0.05));
  check::relative("rate", of_rates.bias[1] / (of_decay.estimates[1] - 1.5), 1., 0.03);
  check::relative("amplitude", of_rates.bias[0] / (of_decay.estimates[0] - 1.), 1., 0.03);
  check::is_true("held", std::isnan(of_rates.bias[2]));

  // A prior that is strong keeps the bias away.
  rates[1].prior = Prior{1.5, 1e-5};
  const FitResult informed = LeastSquaresFit(rates, decays, exponential, options).solve();
  check::is_true("with a prior",
                 std::abs(model_bias(rates, informed, decays, decay(informed.estimates, 0.),
                                     decay(informed.estimates, 0.05))
                              .bias[1]) < 1e-3 * std::abs(of_rates.bias[1]));
  check::throws<std::invalid_argument>(
      "no derivatives", [&]() { model_bias(parameters, FitResult(), records, model, other); },
      "a fit with derivatives");
  check::throws<std::invalid_argument>(
      "lengths", [&]() { model_bias(parameters, fit, records, {1.}, other); },
      "predictions of all values");
}
} // namespace test_of_model_bias
