#include "../unit_test.h"
#include "records.h"

#include <continua/inference/start_points.h>

#include <algorithm>
#include <cmath>

namespace test_of_start_points
{
using namespace Continua;

UNIT_TEST(start_points)
{
  FitParameter modulus = parameter_of("modulus", 1e6, FitParameter::Scale::logarithmic);
  modulus.lower = 1e5;
  modulus.upper = 1e7;
  FitParameter shift = parameter_of("shift", 0.);
  shift.prior = Prior{0.1, 0.01};
  const std::vector<FitParameter> parameters{modulus, shift, held_parameter("held", 7.),
                                             parameter_of("free", -2.)};
  const auto points = start_points(parameters, 200);
  check::is_true("number", points.size() == 200);
  check::is_true("the given one first", points[0] == std::vector<double>({1e6, 0., 7., -2.}));
  unsigned int n_below = 0;
  double lowest = 1.;
  double highest = 0.;
  bool is_within = true;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    n_below += points[i][0] < 1e6 ? 1 : 0;
    lowest = std::min(lowest, points[i][1]);
    highest = std::max(highest, points[i][1]);
    is_within = is_within && points[i][0] >= 1e5 && points[i][0] <= 1e7 && points[i][2] == 7. &&
                points[i][3] >= -8. && points[i][3] <= 4.;
  }
  check::is_true("within the ranges", is_within);
  check::absolute("half below the middle of the logarithms", n_below / 199., 0.5, 0.02);
  check::absolute("lower end of the prior", lowest, 0.08, 0.001);
  check::absolute("upper end of the prior", highest, 0.12, 0.001);
}
} // namespace test_of_start_points
