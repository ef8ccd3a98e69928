#include <continua/base/interpolant.h>

#include "../unit_test.h"

namespace test_of_interpolant
{
using namespace Continua;

UNIT_TEST(interpolant)
{
  const Interpolant nothing;
  check::absolute("zero", nothing(0.3) + nothing(-7.) + nothing(7.), 0., 0.);

  const Interpolant linear({0., 1., 3.}, {2., 4., 0.}, Interpolant::Kind::linear);
  check::relative("linear", linear(0.25), 2.5, 1e-15);
  check::relative("linear, second interval", linear(2.), 2., 1e-15);
  check::absolute("at a point", linear(1.), 4., 0.);
  check::absolute("before", linear(-1.), 2., 0.);
  check::absolute("after", linear(9.), 0., 0.);
  check::is_true("ends", linear.first_point() == 0. && linear.last_point() == 3.);

  // Fritsch and Butland: the slope between secants 1 and 4 on equal intervals is their harmonic
  // mean 1.6, at an extremum 0.
  const Interpolant cubic({0., 1., 2., 3.}, {0., 1., 5., 4.}, Interpolant::Kind::cubic);
  const double step = 1e-6;
  check::absolute("slope", (cubic(1. + step) - cubic(1. - step)) / (2. * step), 1.6, 1e-5);
  check::absolute("slope at an extremum", (cubic(2. + step) - cubic(2. - step)) / (2. * step), 0.,
                  1e-5);
  const Interpolant straight({0., 1., 5.}, {1., 3., 11.}, Interpolant::Kind::cubic);
  check::relative("straight line", straight(3.7), 8.4, 1e-14);
  const Interpolant periodic({0., 1., 3., 4.}, {0., 1., -1., 0.}, Interpolant::Kind::cubic, true);
  check::relative("periodic", (periodic(step) - periodic(0.)) / step, 1., 1e-5);
}
} // namespace test_of_interpolant
