// The prestretch of a tube: F0^-1 along the axis, around it and across, a share of it, and what
// cannot be.

#include <continua/materials/prestretch.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

#include "../unit_test.h"

namespace test_of_prestretch
{
using namespace Continua;
using namespace dealii;

UNIT_TEST(prestretch)
{
  const Prestretch none, ring{1.25, 1.6};
  check::is_true("none", !none.exists() && ring.exists());
  Tensor<1, 3> axis, around;
  axis[0] = 1.;
  around[1] = -0.6;
  around[2] = 0.8;
  const Tensor<1, 3> across = cross_product_3d(axis, around);
  check::absolute(
      "none: nothing changes",
      (none.inverse(axis, around, 1.) - Tensor<2, 3>(unit_symmetric_tensor<3>())).norm(), 0.,
      1e-15);
  const Tensor<2, 3> inverse = ring.inverse(axis, around, 1.);
  check::relative("along", axis * inverse * axis, 1.25, 1e-14);
  check::relative("around", around * inverse * around, 2. * numbers::PI / (2. * numbers::PI - 1.6),
                  1e-14);
  check::relative("across", across * inverse * across, 1., 1e-14);
  check::relative("volume", ring.volume_ratio(1.) * determinant(inverse), 1., 1e-14);
  check::relative("half of it: along", axis * ring.inverse(axis, around, 0.5) * axis, 1. / 0.9,
                  1e-14);
  check::relative("half of it: volume",
                  ring.volume_ratio(0.5) * determinant(ring.inverse(axis, around, 0.5)), 1., 1e-14);
}
} // namespace test_of_prestretch
