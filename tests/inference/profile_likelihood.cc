#include "../unit_test.h"
#include "function_model.h"
#include "random_noise.h"
#include "records.h"

#include <continua/inference/profile_likelihood.h>

#include <cmath>
#include <stdexcept>

namespace test_of_profile_likelihood
{
using namespace Continua;

namespace
{
using Values = std::vector<double>;

constexpr double chi_square_95 = 3.841458820694124;

Profile profile_of(FunctionModel &model,
                   const std::vector<FitParameter> &parameters,
                   const DataRecord &record,
                   const unsigned int parameter)
{
  FitOptions options;
  options.tolerance = 1e-8;
  options.correlated_noise = CorrelatedNoise::as_given;
  const FitResult fit = LeastSquaresFit(parameters, {record}, model, options).solve();
  return profile_likelihood(parameters, {record}, model, options, fit, parameter);
}

/// y1 = a^2 + b and y2 = b with noise 1: a^2 lies within (y1 - y2) -+ 1.96 sqrt(2).
void test_square()
{
  FunctionModel model(
      [](const Values &set) -> Values {
        return {set[0] * set[0] + set[1], set[1]};
      });
  const DataRecord record = uniform_record("y", 0., {9., 3.}, 1.);
  const std::vector<FitParameter> parameters{parameter_of("a", 2.), parameter_of("b", 1.)};
  const Profile profile = profile_of(model, parameters, record, 0);
  const double half = std::sqrt(2. * chi_square_95);
  check::relative("threshold", profile.threshold, chi_square_95, 1e-9);
  check::relative("lower end", profile.interval.lower, std::sqrt(6. - half), 2e-3);
  check::relative("upper end", profile.interval.upper, std::sqrt(6. + half), 2e-3);
  check::is_true("two ends", !profile.interval.lower_is_bound && !profile.interval.upper_is_bound &&
                                 profile.remark.empty());
  bool is_exact = profile.points.size() >= 8;
  for (const Profile::Point &point : profile.points)
    is_exact = is_exact &&
               std::abs(point.misfit - std::pow(point.value * point.value - 6., 2) / 2.) < 1e-6 &&
               std::abs(point.estimates[1] - (3. + (9. - point.value * point.value)) / 2.) < 1e-5;
  check::is_true("profile in closed form", is_exact);

  auto bounded = parameters;
  bounded[0].lower = 2.;
  const Profile at_bound = profile_of(model, bounded, record, 0);
  check::is_true("meets the bound",
                 at_bound.interval.lower == 2. && at_bound.interval.lower_is_bound);
  check::equal("is said", at_bound.remark, "it meets the bound 2 1 below the threshold");
  check::relative("the other end", at_bound.interval.upper, std::sqrt(6. + half), 2e-3);

  // a^2 = 1 is 5/sqrt(2) of chi-square away: with data nearer to zero the lower end is not there.
  const Profile open = profile_of(model, parameters, uniform_record("y", 0., {4., 3.}, 1.), 0);
  check::is_true("no lower end", !(open.interval.lower > 0.) || open.interval.lower_is_bound);
  FunctionModel failing(
      [](const Values &set) -> Values
      {
        if (set[0] > 2.6)
          throw std::runtime_error("it bursts");
        return {set[0] * set[0] + set[1], set[1]};
      });
  const Profile stopped = profile_of(failing, parameters, record, 0);
  check::is_true("a failure is said",
                 check::matches(stopped.remark, "the model fails at .*it bursts"));
}

/// With estimated noise the profile of a straight line gives Student's interval.
void test_line()
{
  FunctionModel model(
      [](const Values &set) -> Values
      {
        return {set[0], set[0] + set[1], set[0] + 2. * set[1], set[0] + 3. * set[1],
                set[0] + 4. * set[1]};
      });
  const DataRecord record = uniform_record("y", 0., {1.1, 2.9, 5.2, 7.1, 8.7}, undefined);
  const Profile profile =
      profile_of(model, {parameter_of("a", 1.), parameter_of("b", 1.)}, record, 1);
  const double half = 3.182446305284263 * std::sqrt(0.124 / 3. / 10.);
  check::relative("Student's lower end", profile.interval.lower, 1.94 - half, 1e-5);
  check::relative("Student's upper end", profile.interval.upper, 1.94 + half, 1e-5);
}

/// The profile of a linear model is the interval of the fit, with a sandwich, too.
void test_sandwich()
{
  FunctionModel model([](const Values &set) -> Values { return Values(200, set[0]); });
  const DataRecord record =
      uniform_record("y", 1., RandomNoise(41).autoregressive({0.6}, 200), undefined);
  FitOptions options;
  options.tolerance = 1e-8;
  options.correlated_noise = CorrelatedNoise::sandwich;
  const FitResult fit =
      LeastSquaresFit({parameter_of("mean", 1.)}, {record}, model, options).solve();
  const Profile profile =
      profile_likelihood({parameter_of("mean", 1.)}, {record}, model, options, fit, 0);
  check::is_true("the sandwich is larger", fit.treated_over_plain_variance[0] > 2.);
  check::absolute("lower end of the sandwich", profile.interval.lower, fit.intervals[0].lower,
                  1e-4);
  check::absolute("upper end of the sandwich", profile.interval.upper, fit.intervals[0].upper,
                  1e-4);
}

/// A curve with two minima: the profile of the wrong one finds the better one.
void test_other_minimum()
{
  FunctionModel model(
      [](const Values &set) -> Values
      {
        Values values;
        for (int i = 0; i < 12; ++i)
          values.push_back(std::pow(set[0] * set[0] - 1., 2) - 0.5 * set[0]);
        return values;
      });
  const DataRecord record = uniform_record("y", 0., Values(12, -0.7), 4.);
  const Profile profile = profile_of(model, {parameter_of("a", -0.9)}, record, 0);
  check::throws<std::invalid_argument>(
      "no fit",
      [&]() {
        profile_likelihood({parameter_of("a", 1.)}, {record}, model, FitOptions(), FitResult(), 0);
      },
      "needs a fit");
  check::is_true("another minimum",
                 check::matches(profile.remark, "a smaller misfit was found at"));
}
} // namespace

UNIT_TEST(profile_likelihood)
{
  test_square();
  test_line();
  test_sandwich();
  test_other_minimum();
}
} // namespace test_of_profile_likelihood
