#include <continua/continuum/kinematics.h>

#include <deal.II/base/symmetric_tensor.h>

namespace Continua
{
using namespace dealii;

Kinematics::Kinematics(const Tensor<2, 3> &displacement_gradient)
    : gradient_of_place(displacement_gradient +
                        static_cast<Tensor<2, 3>>(unit_symmetric_tensor<3>()))
{
  // det(1 + H) - 1 by the invariants of H.
  const Tensor<2, 3> &h = displacement_gradient;
  const double first = trace(h);
  change_of_volume = first + 0.5 * (first * first - trace(h * h)) + determinant(h);
  if (volume_ratio() != 0.)
    inverse_gradient = invert(gradient_of_place);
}
} // namespace Continua
