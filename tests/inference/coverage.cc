#include "../unit_test.h"
#include "function_model.h"
#include "random_noise.h"
#include "records.h"

#include <continua/inference/least_squares_fit.h>

#include <array>
#include <cmath>

namespace test_of_coverage
{
using namespace Continua;

namespace
{
using Values = std::vector<double>;

constexpr unsigned int n_values = 120;
const Values truth{2., 0.8};

/// A pulse that decays: amplitude t/s exp(1 - t/s) with s the time of its top.
class Pulse : public FitModel
{
public:
  static Values at(const Values &set)
  {
    Values values(n_values);
    for (unsigned int i = 0; i < n_values; ++i)
    {
      const double t = 0.05 * (i + 1) / set[1];
      values[i] = set[0] * t * std::exp(1. - t);
    }
    return values;
  }
  std::vector<Prediction> predict(const std::vector<Values> &sets) override
  {
    std::vector<Prediction> predictions;
    predictions.reserve(sets.size());
    for (const Values &set : sets)
      predictions.push_back({at(set), ""});
    return predictions;
  }
  bool derivatives(const Values &set, std::vector<Values> &by_parameter) override
  {
    by_parameter.assign(2, Values(n_values));
    for (unsigned int i = 0; i < n_values; ++i)
    {
      const double t = 0.05 * (i + 1) / set[1];
      by_parameter[0][i] = t * std::exp(1. - t);
      by_parameter[1][i] = set[0] * std::exp(1. - t) * t * (t - 1.) / set[1];
    }
    return true;
  }
};

struct Coverage
{
  std::array<double, 2> covered{}, mean_error{};
};

/// Of experiments with noise drawn anew: how often the 95 % intervals contain the truth, and
/// the mean of (estimate - truth)/standard error.
Coverage coverage_of(const unsigned long seed,
                     const Values &coefficients,
                     const double deviation,
                     const FitOptions &options,
                     const unsigned int n_experiments = 1000)
{
  RandomNoise random(seed);
  Pulse pulse;
  const Values exact = Pulse::at(truth);
  std::vector<FitParameter> parameters{
      parameter_of("amplitude", 1.5, FitParameter::Scale::logarithmic),
      parameter_of("time", 1., FitParameter::Scale::logarithmic)};
  Coverage coverage;
  for (unsigned int k = 0; k < n_experiments; ++k)
  {
    Values values = random.autoregressive(coefficients, n_values);
    for (unsigned int i = 0; i < n_values; ++i)
      values[i] = exact[i] + 0.05 * values[i];
    const FitResult result =
        LeastSquaresFit(parameters, {uniform_record("y", 0.05, values, deviation)}, pulse, options)
            .solve();
    for (unsigned int j = 0; j < 2; ++j)
    {
      coverage.covered[j] +=
          result.intervals[j].lower <= truth[j] && truth[j] <= result.intervals[j].upper
              ? 1. / n_experiments
              : 0.;
      coverage.mean_error[j] +=
          (result.estimates[j] - truth[j]) / result.standard_errors[j] / n_experiments;
    }
  }
  return coverage;
}

void compare(const std::string &name, const Coverage &coverage)
{
  for (unsigned int j = 0; j < 2; ++j)
  {
    const std::string parameter = j == 0 ? ", amplitude: " : ", time: ";
    check::absolute(name + parameter + "95 % intervals", coverage.covered[j], 0.95, 0.02);
    check::absolute(name + parameter + "mean error over the standard error", coverage.mean_error[j],
                    0., 0.12);
  }
}
} // namespace

UNIT_TEST(coverage)
{
  FitOptions options;
  options.correlated_noise = CorrelatedNoise::as_given;
  compare("white, known", coverage_of(101, {}, 0.05, options));
  compare("white, estimated", coverage_of(102, {}, undefined, options));
  const Coverage ignored = coverage_of(103, {0.6}, undefined, options, 200);
  check::is_true("correlation ignored covers too little",
                 ignored.covered[0] < 0.85 && ignored.covered[1] < 0.9);
  options.correlated_noise = CorrelatedNoise::autoregressive;
  compare("autoregressive", coverage_of(103, {0.6}, undefined, options));
  // Six values' worth of independent ones: a little less than 95 %.
  const Coverage strong = coverage_of(105, {0.9}, undefined, options, 300);
  check::absolute("strongly autoregressive, amplitude", strong.covered[0], 0.92, 0.05);
  options.correlated_noise = CorrelatedNoise::enlarged;
  const Coverage enlarged = coverage_of(104, {0.6}, undefined, options, 300);
  check::is_true("enlarged covers more than nothing done",
                 enlarged.covered[0] > ignored.covered[0] + 0.1 &&
                     enlarged.covered[1] > ignored.covered[1] + 0.1);
}
} // namespace test_of_coverage
