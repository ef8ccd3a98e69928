#include "../unit_test.h"
#include "random_noise.h"

#include <continua/inference/autoregressive_model.h>
#include <continua/inference/restricted_likelihood.h>

#include <cmath>
#include <numeric>

namespace test_of_restricted_likelihood
{
using namespace Continua;

namespace
{
/// Residuals about the mean, which is the only parameter.
ResidualsOfRecord about_mean(std::vector<double> values)
{
  const double mean = std::accumulate(values.begin(), values.end(), 0.) / values.size();
  for (double &value : values)
    value -= mean;
  ResidualsOfRecord record;
  record.interval = 1.;
  record.columns = {std::vector<double>(values.size(), 1.)};
  record.residuals = std::move(values);
  record.other_information.reinit(1, 1);
  return record;
}

NoiseModel start_of(const ResidualsOfRecord &record, const unsigned int order)
{
  const AutoregressiveModel model = fit_autoregressive_model(record.residuals, order, false);
  NoiseModel noise;
  noise.autoregressive = model.coefficients;
  noise.standard_deviation = model.standard_deviation;
  return noise;
}
} // namespace

UNIT_TEST(restricted_likelihood)
{
  // White noise about its mean: the variance is the sum of the squares over n - 1.
  const ResidualsOfRecord white = about_mean({1., 4., 2., 8., 5.});
  const NoiseModel of_white = restricted_likelihood_noise(white, start_of(white, 0), false);
  check::relative("white noise about a mean", of_white.standard_deviation, std::sqrt(30. / 4.),
                  1e-4);

  // A mean that others know with much more information takes nothing.
  ResidualsOfRecord known = white;
  known.other_information(0, 0) = 1e12;
  check::relative("about a mean that is known",
                  restricted_likelihood_noise(known, start_of(known, 0), false).standard_deviation,
                  std::sqrt(30. / 5.), 1e-4);

  // 300 short records of order 1: Burg's coefficients about the mean are too small by
  // about (1 + 3 phi)/n (Shaman and Stine, J. Am. Stat. Assoc. 83, 1988, 842), those of the
  // restricted likelihood by much less.
  RandomNoise random(21);
  double of_burg = 0.;
  double of_likelihood = 0.;
  double variance = 0.;
  const unsigned int n_records = 300;
  for (unsigned int k = 0; k < n_records; ++k)
  {
    const ResidualsOfRecord record = about_mean(random.autoregressive({0.6}, 40));
    const NoiseModel start = start_of(record, 1);
    const NoiseModel found = restricted_likelihood_noise(record, start, false);
    of_burg += start.autoregressive[0] / n_records;
    of_likelihood += found.autoregressive[0] / n_records;
    variance += std::pow(found.standard_deviation, 2) *
                (1. - std::pow(found.autoregressive[0], 2)) / n_records;
  }
  check::absolute("Burg's coefficient", of_burg, 0.6 - 2.8 / 40., 0.02);
  check::absolute("the likelihood's coefficient", of_likelihood, 0.6, 0.04);
  check::relative("innovations", variance, 1., 0.05);

  const ResidualsOfRecord record = about_mean(random.autoregressive({1.2, -0.6}, 2000));
  NoiseModel start = start_of(record, 2);
  const NoiseModel found = restricted_likelihood_noise(record, start, false);
  check::absolute("order 2, first", found.autoregressive[0], 1.2, 0.06);
  check::absolute("order 2, second", found.autoregressive[1], -0.6, 0.06);
  start.standard_deviation = 1.7;
  check::relative("a known deviation stays",
                  restricted_likelihood_noise(record, start, true).standard_deviation, 1.7, 0.);
}
} // namespace test_of_restricted_likelihood
