#ifndef continua_continuum_kinematics_h
#define continua_continuum_kinematics_h

#include <deal.II/base/tensor.h>

namespace Continua
{
/**
 * The motion x = X + d of the reference mesh at a point: gradients by the present place, dv and
 * n da. Gradients are 3x3 in every model: in plane strain (Grad d)_33 = 0, in axisymmetry
 * (Grad d)_33 = d_R/R, so that the hoop strain and the ratio of the circumferences follow by
 * themselves.
 */
class Kinematics
{
public:
  /// Of the gradient of the displacement by the reference place, Grad d [1].
  explicit Kinematics(const dealii::Tensor<2, 3> &displacement_gradient);

  /// F = I + Grad d [1].
  const dealii::Tensor<2, 3> &deformation_gradient() const { return gradient_of_place; }
  /// F^-1 [1]; without meaning where the volume ratio is not positive.
  const dealii::Tensor<2, 3> &inverse() const { return inverse_gradient; }
  /// J = det F = dv/dV [1].
  double volume_ratio() const { return 1. + change_of_volume; }
  /// J - 1 [1], also where it is far below the round-off of J.
  double volume_change() const { return change_of_volume; }
  /// The gradient by the present place, grad f = Grad f F^-1, of a vector's by the reference place.
  dealii::Tensor<2, 3> gradient(const dealii::Tensor<2, 3> &reference_gradient) const
  {
    return reference_gradient * inverse_gradient;
  }
  /// n da = J F^-T N dA.
  dealii::Tensor<1, 3> area(const dealii::Tensor<1, 3> &reference_area) const
  {
    return volume_ratio() * (reference_area * inverse_gradient);
  }

private:
  dealii::Tensor<2, 3> gradient_of_place, inverse_gradient;
  double change_of_volume;
};

/// The 3x3 gradient of a vector from its gradient in the plane or in space and, in axisymmetry, its
/// radial component over the radius.
template <int dim>
dealii::Tensor<2, 3> whole_gradient(const dealii::Tensor<2, dim> &gradient, const double hoop)
{
  dealii::Tensor<2, 3> whole;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int d = 0; d < dim; ++d)
      whole[c][d] = gradient[c][d];
  if (dim == 2)
    whole[2][2] = hoop;
  return whole;
}
} // namespace Continua

#endif
