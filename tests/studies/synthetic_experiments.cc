// Synthetic experiments with a straight line, whose errors theory knows, and with noise that a fit
// is not told of.

#include <continua/inference/fit_model.h>
#include <continua/studies/synthetic_experiments.h>

#include "../unit_test.h"

#include <cmath>

namespace test_of_synthetic_experiments
{
using namespace Continua;

namespace
{
constexpr unsigned int n = 60, n_experiments = 400;
constexpr double interval = 0.1;

/// a + b t
class Line : public FitModel
{
public:
  std::vector<Prediction> predict(const std::vector<std::vector<double>> &sets) override
  {
    std::vector<Prediction> result;
    for (const auto &set : sets)
    {
      result.emplace_back();
      for (unsigned int i = 0; i < n; ++i)
        result.back().values.push_back(set[0] + set[1] * interval * i);
    }
    return result;
  }
};

struct Setting
{
  std::vector<FitParameter> parameters = std::vector<FitParameter>(2);
  std::vector<DataRecord> records = std::vector<DataRecord>(1);
  std::vector<double> truth = {2., 3.}, errors;
  Line line;

  Setting()
  {
    parameters[0].name = "level";
    parameters[0].start = 2.;
    parameters[1].name = "slope";
    parameters[1].start = 3.;
    records[0].name = "line";
    records[0].interval = interval;
    double mean = 0., square = 0.;
    for (unsigned int i = 0; i < n; ++i)
    {
      records[0].times.push_back(interval * i);
      mean += interval * i / n;
      square += interval * i * interval * i;
    }
    records[0].noise.standard_deviation = 0.3;
    // Of the slope sigma/sqrt(sum (t - mean)^2), of the level sigma sqrt(1/n + mean^2/sum ...).
    const double sum = square - n * mean * mean;
    errors = {0.3 * std::sqrt(1. / n + mean * mean / sum), 0.3 / std::sqrt(sum)};
  }
  SyntheticExperiments::Outcome
  perform(const NoiseModel &noise, const FitOptions &options, const unsigned int seed)
  {
    return SyntheticExperiments(parameters, truth, errors, records, {noise}, options)
        .perform(line, n_experiments, seed);
  }
};
} // namespace

UNIT_TEST(synthetic_experiments)
{
  Setting setting;
  const auto white = setting.perform(setting.records[0].noise, {}, 1);
  check::is_true("all fitted", white.fits.size() == n_experiments && white.n_failed == 0);
  check::absolute("a line is interpolated exactly", white.interpolation_error, 0., 1e-10);
  check::relative("standard error of the slope", white.fits[0].standard_errors[1],
                  setting.errors[1], 1e-6);
  for (unsigned int j = 0; j < 2; ++j)
  {
    const std::string &name = setting.parameters[j].name;
    // Three standard deviations of means, spreads and parts of so many experiments.
    check::absolute("mean error of the " + name, white.parameters[j].mean_error, 0., 0.15);
    check::absolute("spread of the " + name, white.parameters[j].spread, 1., 0.11);
    check::absolute("coverage of the " + name, white.parameters[j].coverage, 0.95, 0.033);
  }
  check::is_true("noise is drawn anew", white.fits[0].estimates[0] != white.fits[1].estimates[0]);
  const auto again = setting.perform(setting.records[0].noise, {}, 1),
             other = setting.perform(setting.records[0].noise, {}, 2);
  check::is_true("by the seed", again.fits[5].estimates == white.fits[5].estimates &&
                                    other.fits[5].estimates != white.fits[5].estimates);

  // Noise that is correlated over five intervals, in fits that take it for white: the intervals are
  // far too short; sigma^2 (1 + phi)/(1 - phi) with phi = exp(-1/5) is the variance of a mean.
  NoiseModel correlated = setting.records[0].noise;
  correlated.correlation_time = 0.5;
  FitOptions as_given;
  as_given.correlated_noise = CorrelatedNoise::as_given;
  const auto wrong = setting.perform(correlated, as_given, 3);
  check::absolute("spread with noise that the fit does not know", wrong.parameters[1].spread,
                  std::sqrt((1. + std::exp(-0.2)) / (1. - std::exp(-0.2))), 0.6);
  check::is_true("coverage with noise that the fit does not know",
                 wrong.parameters[1].coverage < 0.7);
  setting.records[0].noise = correlated;
  const auto told = setting.perform(correlated, as_given, 3);
  check::absolute("coverage if it does", told.parameters[1].coverage, 0.95, 0.033);
}
} // namespace test_of_synthetic_experiments
