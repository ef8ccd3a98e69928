// The stretch of a deformation without its turn: of a rotated stretch, of a rotation, and its
// change against differences.

#include <continua/continuum/right_stretch.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

#include "../unit_test.h"

namespace test_of_right_stretch
{
using namespace Continua;
using namespace dealii;

UNIT_TEST(right_stretch)
{
  Tensor<2, 3> rotation, stretch, change;
  rotation[0][0] = rotation[1][1] = std::cos(0.7);
  rotation[1][0] = std::sin(0.7);
  rotation[0][1] = -rotation[1][0];
  rotation[2][2] = 1.;
  const double stretches[3][3] = {{1.4, 0.2, 0.1}, {0.2, 0.9, -0.3}, {0.1, -0.3, 1.1}},
               changes[3][3] = {{0.3, -0.5, 0.2}, {0.7, 0.1, 0.4}, {-0.6, 0.2, -0.3}};
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
    {
      stretch[i][j] = stretches[i][j];
      change[i][j] = changes[i][j];
    }
  const Tensor<2, 3> gradient = rotation * stretch;
  const RightStretch turned(gradient);
  check::absolute("a turned stretch", (turned.inverse() - invert(stretch)).norm(), 0., 1e-13);
  const Tensor<2, 3> unit = unit_symmetric_tensor<3>();
  check::absolute("a turn alone", (RightStretch(rotation).inverse() - unit).norm(), 0., 1e-14);
  const double h = 1e-5;
  const Tensor<2, 3> difference = (invert(RightStretch(gradient + h * change).inverse()) -
                                   invert(RightStretch(gradient - h * change).inverse())) /
                                  (2. * h);
  check::absolute("its change", (turned.change(change) - difference).norm(), 0., 1e-9);
  // A turn that goes on leaves it as it is.
  Tensor<2, 3> spin;
  spin[1][2] = 1.;
  spin[2][1] = -1.;
  check::absolute("a further turn", turned.change(spin * gradient).norm(), 0., 1e-14);
}
} // namespace test_of_right_stretch
