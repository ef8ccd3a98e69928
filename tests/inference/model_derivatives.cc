#include "../unit_test.h"
#include "function_model.h"
#include "records.h"

#include <continua/inference/model_derivatives.h>

#include <cmath>
#include <stdexcept>

namespace test_of_model_derivatives
{
using namespace Continua;

namespace
{
using Values = std::vector<double>;

class AnalyticModel : public FitModel
{
public:
  std::vector<Prediction> predict(const std::vector<Values> &) override { return {}; }
  bool derivatives(const Values &set, std::vector<Values> &by_parameter) override
  {
    by_parameter = {{2. * set[0]}, {3.}};
    return true;
  }
};
} // namespace

UNIT_TEST(model_derivatives)
{
  const auto logarithmic = FitParameter::Scale::logarithmic;
  FunctionModel function(
      [](const Values &set) -> Values {
        return {std::exp(set[0]) * set[1], set[0] * set[0] * set[0]};
      });
  EvaluatedModel model(function, 2);
  std::vector<FitParameter> parameters{parameter_of("a", 0.5), parameter_of("b", 3., logarithmic)};
  const ModelDerivatives central = model_derivatives(parameters, model, {0.5, 3.}, {0, 1}, 1e-3);
  check::is_true("all in one call", function.n_calls == 1 && function.n_sets == 4);
  check::relative("linear", central.columns[0][0], 3. * std::exp(0.5), 1e-7);
  // Central differences of x^3 are off by h^2, h = 0.001 * 0.5.
  check::relative("second order", central.columns[0][1] - 0.75, 0.25e-6, 1e-3);
  check::relative("by the logarithm", central.columns[1][0], 3. * std::exp(0.5), 1e-6);
  const ModelDerivatives one = model_derivatives(parameters, model, {0.5, 3.}, {1}, 1e-3);
  check::is_true("only what is asked for", one.columns[0].empty() && one.columns[1].size() == 2);

  // At bounds: three points to one side, off by -2 h^2 for x^3.
  parameters[0].lower = 0.5;
  const double below = model_derivatives(parameters, model, {0.5, 3.}, {0}, 1e-3).columns[0][1];
  check::relative("three points at the lower bound", below - 0.75, -0.5e-6, 5e-3);
  parameters[0].lower = 0.;
  parameters[0].upper = 0.5;
  check::relative("three points at the upper bound",
                  model_derivatives(parameters, model, {0.5, 3.}, {0}, 1e-3).columns[0][1] - 0.75,
                  -0.5e-6, 5e-3);
  parameters[0].lower = 0.5 - 1e-5;
  check::relative("narrow bounds",
                  model_derivatives(parameters, model, {0.5 - 4e-6, 3.}, {0}, 1e-3).columns[0][1],
                  3. * std::pow(0.5 - 4e-6, 2), 1e-7);

  FitParameter narrow = parameter_of("b", 3., logarithmic);
  narrow.lower = 3. - 1e-4;
  narrow.upper = 3. + 1e-4;
  check::relative(
      "narrow bounds of a logarithm",
      model_derivatives({parameters[0], narrow}, model, {0.5, 3.}, {1}, 1e-3).columns[1][0],
      3. * std::exp(0.5), 1e-8);

  // Failures on one side, and on both.
  FunctionModel wall(
      [](const Values &set) -> Values
      {
        if (set[0] > 1.)
          throw std::runtime_error("too far");
        return {set[0] * set[0]};
      });
  EvaluatedModel beside(wall, 1);
  check::relative("beside a failure",
                  model_derivatives({parameter_of("a", 1.)}, beside, {1.}, {0}, 1e-3).columns[0][0],
                  2., 1e-9);
  const ModelDerivatives none = model_derivatives({parameter_of("a", 2.)}, beside, {2.}, {0}, 1e-3);
  check::equal(
      "failure on either side", none.failure,
      "the derivative by 'a' cannot be taken, since the model fails on either side: too far");

  AnalyticModel analytic;
  EvaluatedModel of_analytic(analytic, 1);
  const ModelDerivatives exact =
      model_derivatives({parameter_of("a", 1.), parameter_of("b", 1., logarithmic)}, of_analytic,
                        {4., 5.}, {0, 1}, 1e-3);
  check::relative("analytic", exact.columns[0][0], 8., 0.);
  check::relative("analytic by the logarithm", exact.columns[1][0], 15., 0.);
}
} // namespace test_of_model_derivatives
