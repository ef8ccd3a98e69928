#include "../unit_test.h"
#include "records.h"

#include <continua/inference/error_freedom.h>
#include <continua/inference/least_squares_factor.h>
#include <continua/inference/weighted_residuals.h>

#include <cmath>

namespace test_of_error_freedom
{
using namespace Continua;

namespace
{
/// Of the mean of records.
double of_mean(const std::vector<DataRecord> &records, const std::vector<EstimatedNoise> &estimated)
{
  const std::vector<FitParameter> parameters{parameter_of("mean", 1.)};
  const WeightedResiduals residuals(parameters, records);
  const std::vector<std::vector<double>> columns{
      residuals.column(0, std::vector<double>(residuals.n_values(), 1.))};
  return degrees_of_freedom_of_errors(records, estimated, columns,
                                      LeastSquaresFactor(columns).inverse_of_normal_matrix())[0];
}
} // namespace

UNIT_TEST(error_freedom)
{
  const DataRecord ten = uniform_record("ten", 0., std::vector<double>(10, 0.), 0.5);
  const DataRecord five = uniform_record("five", 0., std::vector<double>(5, 0.), 2.);
  check::relative("one record", of_mean({ten}, {{true, 0}}), 9., 1e-12);
  // Two parameters that nearly trade off leave eight values.
  std::vector<std::vector<double>> alike(2, std::vector<double>(10, 1.));
  for (std::size_t i = 0; i < 10; ++i)
    alike[1][i] += 1e-6 * static_cast<double>(i * i);
  const std::vector<double> of_alike = degrees_of_freedom_of_errors(
      {ten}, {{true, 0}}, alike, LeastSquaresFactor(alike).inverse_of_normal_matrix());
  check::relative("nearly alike, first", of_alike[0], 8., 1e-8);
  check::relative("nearly alike, second", of_alike[1], 8., 1e-8);
  check::is_true("known noise", std::isinf(of_mean({ten}, {{false, 0}})));
  // A weighted mean: shares a and 1 - a of the information, 10/0.25 and 5/4; as many values are
  // taken of each record.
  const double a = 40. / 41.25;
  check::relative("two records", of_mean({ten, five}, {{true, 0}, {true, 0}}),
                  1. / (a * a / (10. - a) + (1. - a) * (1. - a) / (4. + a)), 1e-12);
  check::relative("one of two is known", of_mean({ten, five}, {{false, 0}, {true, 0}}),
                  (4. + a) / ((1. - a) * (1. - a)), 1e-12);

  // A long record of order 1: ln of the variance of the mean is ln of the innovations' variance
  // less 2 ln(1 - phi), and the variance of phi is (1 - phi^2)/n.
  const double phi = 0.6;
  const double n = 5000.;
  DataRecord coloured = uniform_record("coloured", 1., std::vector<double>(5000, 0.), 1.);
  coloured.noise.autoregressive = {phi};
  check::relative("order 1", of_mean({coloured}, {{true, 1}}),
                  2. / (2. / (n - 1.) + 4. * (1. - phi * phi) / ((1. - phi) * (1. - phi) * n)),
                  5e-3);
  // With the deviation known: ln((1 + phi)/(1 - phi)).
  check::relative("order 1, known deviation", of_mean({coloured}, {{false, 1}}),
                  2. / (std::pow(2. / (1. - phi * phi), 2) * (1. - phi * phi) / n), 5e-3);
}
} // namespace test_of_error_freedom
