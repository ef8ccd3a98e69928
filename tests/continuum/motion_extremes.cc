// The largest strain and rotation of points of solids: simple shear, a hoop strain, and a rotated
// stretch, small and finite.

#include <continua/continuum/motion_extremes.h>
#include <continua/continuum/problem.h>

#include <cmath>

#include "../unit_test.h"

namespace test_of_motion_extremes
{
using namespace Continua;
using namespace dealii;

UNIT_TEST(motion_extremes)
{
  Problem problem;
  {
    // Simple shear by 0.02 has the principal strains +-0.01 and the rotation 0.01.
    Tensor<2, 3> shear;
    shear[1][2] = 0.02;
    MotionExtremes extremes;
    take_point_of_solid<3>(shear, 0., problem, 0, extremes);
    check::absolute("shear: strain", extremes.strain, 0.01, 1e-15);
    check::absolute("shear: rotation", extremes.rotation, 0.01, 1e-15);
    // A smaller one changes nothing.
    take_point_of_solid<3>(0.5 * shear, 0., problem, 0, extremes);
    check::absolute("the largest stays", extremes.strain, 0.01, 1e-15);
  }
  {
    problem.model = Model::axisymmetric;
    MotionExtremes extremes;
    Tensor<2, 2> gradient;
    gradient[0][0] = 0.01;
    take_point_of_solid<2>(gradient, -0.03, problem, 0, extremes);
    check::absolute("hoop: strain", extremes.strain, 0.03, 1e-15);
    check::absolute("hoop: rotation", extremes.rotation, 0., 1e-15);
  }
  // F = R U with the turn 2.5 about z and the stretches 1.2, 0.7 and 1.
  const double cosine = std::cos(2.5), sine = std::sin(2.5);
  Tensor<2, 3> turned;
  turned[0][0] = 1.2 * cosine - 1.;
  turned[0][1] = -0.7 * sine;
  turned[1][0] = 1.2 * sine;
  turned[1][1] = 0.7 * cosine - 1.;
  problem.model = Model::three_dimensional;
  problem.deformation = Deformation::finite;
  MotionExtremes extremes;
  take_point_of_solid<3>(turned, 0., problem, 0, extremes);
  check::absolute("turned stretch: strain", extremes.strain, 0.3, 1e-14);
  check::absolute("turned stretch: rotation", extremes.rotation, 2.5, 1e-14);

  LiquidSizes tube;
  tube.volume = 3. * 4. * 4.; // pi L R^2 without pi
  tube.area = 2. * 3. * 4.;
  tube.area_of_solids = 1.;
  tube.set(extremes);
  check::absolute("radius of a tube", extremes.liquid_radius, 4., 1e-14);
  check::absolute("area of its walls", extremes.wall_area, 1., 0.);
}
} // namespace test_of_motion_extremes
