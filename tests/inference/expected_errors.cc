#include "../unit_test.h"
#include "function_model.h"
#include "records.h"

#include <continua/base/input_error.h>
#include <continua/inference/expected_errors.h>

#include <cmath>
#include <stdexcept>

namespace test_of_expected_errors
{
using namespace Continua;

namespace
{
using Values = std::vector<double>;

DataRecord one_value(const double place, const double deviation)
{
  DataRecord record = uniform_record("x", 0., {0.}, deviation);
  record.times = {place};
  record.values.clear();
  return record;
}

/// A straight line measured at one place of five each: the two ends are the best pair for the
/// slope.
void test_line()
{
  const Values places{0., 1., 2., 3., 4.};
  FunctionModel model(
      [&](const Values &set) -> Values
      {
        Values values;
        for (const double x : places)
          values.push_back(set[0] + set[1] * x);
        return values;
      });
  std::vector<DataRecord> records;
  for (const double x : places)
    records.push_back(one_value(x, 0.3));
  const std::vector<FitParameter> line{parameter_of("a", 2.), parameter_of("b", 3.)};
  const ExpectedErrors errors(line, records, model);
  check::is_true("one call of the model", model.n_calls == 1);
  const ExpectedErrors::Errors all = errors.of_all();
  check::relative("slope", all.standard_errors[1], 0.3 / std::sqrt(10.), 1e-9);
  check::relative("intercept", all.standard_errors[0], 0.3 * std::sqrt(0.6), 1e-9);
  check::relative("correlation", all.correlation(0, 1), -2. / std::sqrt(6.), 1e-9);
  // det = 5 * 10 / 0.3^4, by the sizes 2 and 3 squared.
  check::relative("determinant", all.log_determinant, std::log(50. / std::pow(0.3, 4) * 36.), 1e-9);
  check::relative("information", errors.information(3)(0, 1), 3. / 0.09, 1e-9);
  check::is_true("nothing is flat", all.flat_directions.empty());

  const std::vector<std::vector<unsigned int>> candidates{{0}, {1}, {2}, {3}, {4}};
  const auto pairs = errors.rank({}, candidates, 2, 1);
  check::is_true("all pairs", pairs.size() == 10);
  check::is_true("best pair", pairs[0].candidates == std::vector<unsigned int>({0, 4}));
  check::relative("its error", pairs[0].errors.standard_errors[1], 0.3 * std::sqrt(2.) / 4., 1e-9);
  check::relative("error of a worst one", pairs[9].errors.standard_errors[1], 0.3 * std::sqrt(2.),
                  1e-9);
  const auto third = errors.rank({0, 4}, candidates, 1, 0);
  check::is_true("best third for the intercept",
                 third[0].candidates[0] == 0 || third[0].candidates[0] == 1);
  const auto by_determinant =
      errors.rank({2}, {{0}, {1}, {3, 4}}, 1, ExpectedErrors::by_determinant);
  check::is_true("best by the determinant", by_determinant[0].candidates[0] == 2);

  const ExpectedErrors::Errors one = errors.of({2});
  check::is_true("one value does not give two parameters", std::isinf(one.standard_errors[0]) &&
                                                               std::isinf(one.log_determinant) &&
                                                               one.flat_directions.size() == 1);
  auto with_prior = line;
  with_prior[0].prior = Prior{2., 0.1};
  const ExpectedErrors informed(with_prior, records, model);
  check::relative("with a prior", informed.of({4}).standard_errors[1], std::hypot(0.3, 0.1) / 4.,
                  1e-9);
  check::is_true("the data do not see what the prior holds",
                 informed.of({4}).flat_directions.size() == 1);
  auto held = line;
  held[0] = held_parameter("a", 2.);
  const ExpectedErrors of_slope(held, records, model);
  check::relative("with the intercept known", of_slope.of({4}).standard_errors[1], 0.3 / 4., 1e-9);
  check::relative("known", of_slope.of({4}).standard_errors[0], 0., 0.);
}

/// The level of noise with a correlation time: sampled without end over T its error tends to
/// s sqrt(2 tau/(T + 2 tau)) (Grenander), white noise would tend to zero.
void test_correlation_time()
{
  const double duration = 1.;
  const double tau = 0.05;
  const auto error = [&](const unsigned int n, const bool is_white)
  {
    FunctionModel model([n](const Values &set) -> Values { return Values(n, set[0]); });
    DataRecord record = uniform_record("y", duration / (n - 1.), Values(n, 0.), 0.2);
    record.noise.correlation_time = is_white ? 0. : tau;
    record.values.clear();
    return ExpectedErrors({parameter_of("level", 5., FitParameter::Scale::logarithmic)}, {record},
                          model)
        .of_all()
        .standard_errors[0];
  };
  const double limit = 0.2 * std::sqrt(2. * tau / (duration + 2. * tau));
  check::relative("fast sampling", error(20001, false), limit, 1e-5);
  const double phi = std::exp(-0.01 / tau);
  check::relative("101 values", error(101, false), 0.2 * std::sqrt((1. + phi) / (101. - 99. * phi)),
                  1e-6);
  check::relative("white", error(20001, true), 0.2 / std::sqrt(20001.), 1e-6);
}

void test_refusals()
{
  FunctionModel model([](const Values &) -> Values { throw std::runtime_error("no run"); });
  check::throws<RunError>(
      "a model that fails",
      [&]() { ExpectedErrors({parameter_of("a", 1.)}, {one_value(0., 1.)}, model); },
      "derivative by 'a' .*no run");
  check::throws<std::invalid_argument>(
      "unknown noise",
      [&]() { ExpectedErrors({parameter_of("a", 1.)}, {one_value(0., undefined)}, model); },
      "standard deviation");
  check::throws<std::invalid_argument>(
      "all known", [&]() { ExpectedErrors({held_parameter("a", 1.)}, {one_value(0., 1.)}, model); },
      "no parameter");
}
} // namespace

UNIT_TEST(expected_errors)
{
  test_line();
  test_correlation_time();
  test_refusals();
}
} // namespace test_of_expected_errors
