#include "../unit_test.h"
#include "records.h"

#include <continua/inference/weighted_residuals.h>

#include <cmath>

namespace test_of_weighted_residuals
{
using namespace Continua;

UNIT_TEST(weighted_residuals)
{
  const auto logarithmic = FitParameter::Scale::logarithmic;
  std::vector<FitParameter> parameters{parameter_of("a", 1.), parameter_of("b", 2., logarithmic),
                                       held_parameter("held", 3.)};
  parameters[0].prior = Prior{4., 0.5};
  parameters[1].prior = Prior{10., 2.};
  parameters[2].prior = Prior{0., 1.};
  std::vector<DataRecord> records{uniform_record("white", 0., {1., 2.}, 0.1),
                                  uniform_record("coloured", 1., {5., 6.}, 2.)};
  records[1].noise.autoregressive = {0.6};
  const WeightedResiduals residuals(parameters, records);
  check::is_true("rows", residuals.n_values() == 4 && residuals.n_rows() == 6);
  const std::vector<double> rows = residuals.rows({5., 20., 3.}, {1.1, 1.9, 7., 7.});
  check::relative("predicted less measured", rows[0], 1., 1e-12);
  check::relative("second value", rows[1], -1., 1e-12);
  check::relative("first of the coloured ones", rows[2], 1., 1e-12);
  check::relative("second of the coloured ones", rows[3], (1. - 1.2) / 1.6, 1e-12);
  check::relative("prior", rows[4], 2., 1e-12);
  check::relative("prior of a logarithm", rows[5], std::log(2.) / 0.2, 1e-12);
  double sum = 0.;
  for (const double row : rows)
    sum += row * row;
  check::relative("misfit", residuals.misfit({5., 20., 3.}, {1.1, 1.9, 7., 7.}), sum, 1e-14);
  const std::vector<double> column = residuals.column(1, {1., 0., 1., 1.});
  check::relative("derivative", column[0], 10., 1e-12);
  check::relative("coloured derivative", column[3], 0.4 / 1.6, 1e-12);
  check::is_true("derivative of the priors", column[4] == 0. && std::abs(column[5] - 5.) < 1e-12);
}
} // namespace test_of_weighted_residuals
