// Stress, strain and traction from gradients against the components worked out by hand.

#include <continua/continuum/stress_and_strain.h>

#include "../unit_test.h"

#include <limits>

namespace test_of_stress_and_strain
{
using namespace Continua;
using namespace dealii;

UNIT_TEST(stress_and_strain)
{
  // w = (x + 2 y, 4 y), hoop 3: the trace is 5 without and 8 with it.
  Tensor<2, 2> gradient;
  gradient[0][0] = 1.;
  gradient[0][1] = 2.;
  gradient[1][1] = 4.;
  const auto plane = stress(gradient, 0., 7., Model::plane_strain);
  check::absolute("xx in plane strain", plane[0], 2. * (1. - 5. / 3.) - 7., 1e-14);
  check::absolute("zz in plane strain", plane[2], -2. * 5. / 3. - 7., 1e-14);
  check::absolute("xy", plane[3], 2., 1e-14);
  const auto round = stress(gradient, 3., 7., Model::axisymmetric);
  check::absolute("yy in axisymmetry", round[1], 2. * (4. - 8. / 3.) - 7., 1e-14);
  check::absolute("the hoop stress", round[2], 2. * (3. - 8. / 3.) - 7., 1e-14);
  check::absolute("the mean stress is -p", round[0] + round[1] + round[2], -21., 1e-13);
  check::absolute("zz in plane stress", stress(gradient, 0., 7., Model::plane_stress)[2], 0., 0.);

  // n.sigma with n = (0.6, 0.8).
  const Tensor<1, 2> force = traction(plane, Tensor<1, 2>({0.6, 0.8}));
  check::absolute("traction x", force[0], 0.6 * plane[0] + 0.8 * plane[3], 1e-14);
  check::absolute("traction y", force[1], 0.6 * plane[3] + 0.8 * plane[1], 1e-14);

  PlaneStressFactors factors;
  factors.thickness_strain_factor = -0.5;
  check::absolute("half the shear angle", strain(gradient, 0., Model::plane_strain, factors)[3], 1.,
                  1e-15);
  check::absolute("no strain across the plane",
                  strain(gradient, 0., Model::plane_strain, factors)[2], 0., 0.);
  check::absolute("the hoop strain", strain(gradient, 3., Model::axisymmetric, factors)[2], 3.,
                  1e-15);
  check::absolute("what keeps the plane free of stress",
                  strain(gradient, 0., Model::plane_stress, factors)[2], -2.5, 1e-15);

  // Three dimensions: w = (z, 2 x, y) shears only.
  Tensor<2, 3> shear;
  shear[0][2] = 1.;
  shear[1][0] = 2.;
  shear[2][1] = 1.;
  const auto solid = stress(shear, 0., 0., Model::three_dimensional);
  check::absolute("xy of three", solid[3], 2., 1e-15);
  check::absolute("xz of three", solid[4], 1., 1e-15);
  check::absolute("yz of three", solid[5], 1., 1e-15);
  const Tensor<1, 3> on_z = traction(solid, Tensor<1, 3>({0., 0., 1.}));
  check::absolute("traction on a plane z", (on_z - Tensor<1, 3>({1., 1., 0.})).norm(), 0., 1e-15);

  // The same as a velocity: curl = (1, 1, 2), and no product of two opposite components.
  const auto curl = vorticity(shear);
  check::is_true("curl", curl[0] == 1. && curl[1] == 1. && curl[2] == 2.);
  check::absolute("pure shear has no Q", q_criterion(shear, 0., Model::three_dimensional), 0., 0.);
  // A rigid rotation by w = 3 about z, |W|^2 = 2 w^2; and a stretching by 3, -3, |E|^2 = 18.
  Tensor<2, 2> rotation, stretching;
  rotation[1][0] = 3.;
  rotation[0][1] = -3.;
  stretching[0][0] = 3.;
  stretching[1][1] = -3.;
  check::absolute("curl of a rotation", vorticity(rotation)[2], 6., 1e-15);
  check::absolute("Q of a rotation", q_criterion(rotation, 0., Model::plane_strain), 9., 1e-15);
  check::absolute("Q of a stretching", q_criterion(stretching, 0., Model::plane_strain), -9.,
                  1e-15);
  check::absolute("Q with a hoop strain rate", q_criterion(stretching, 2., Model::axisymmetric),
                  -11., 1e-15);
}
} // namespace test_of_stress_and_strain
