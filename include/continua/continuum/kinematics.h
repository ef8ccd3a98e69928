#ifndef continua_continuum_kinematics_h
#define continua_continuum_kinematics_h

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <type_traits>

namespace Continua
{
/**
 * The motion x = X + d of the reference mesh at a point: gradients by the present place, dv and
 * n da. Gradients are 3x3 in every model: in plane strain (Grad d)_33 = 0, in axisymmetry
 * (Grad d)_33 = d_R/R, so that the hoop strain and the ratio of the circumferences follow by
 * themselves. `Number`: double, or several points at once.
 */
template <typename Number>
class KinematicsOf
{
public:
  using Matrix = dealii::Tensor<2, 3, Number>;

  /// Of the gradient of the displacement by the reference place, Grad d [1].
  explicit KinematicsOf(const Matrix &displacement_gradient);

  /// F = I + Grad d [1].
  const Matrix &deformation_gradient() const { return gradient_of_place; }
  /// F^-1 [1]; without meaning where the volume ratio is not positive.
  const Matrix &inverse() const { return inverse_gradient; }
  /// J = det F = dv/dV [1].
  Number volume_ratio() const { return 1. + change_of_volume; }
  /// J - 1 [1], also where it is far below the round-off of J.
  Number volume_change() const { return change_of_volume; }
  /// The gradient by the present place, grad f = Grad f F^-1, of a vector's by the reference place.
  Matrix gradient(const Matrix &reference_gradient) const
  {
    return reference_gradient * inverse_gradient;
  }
  /// n da = J F^-T N dA.
  dealii::Tensor<1, 3, Number> area(const dealii::Tensor<1, 3, Number> &reference_area) const
  {
    return volume_ratio() * (reference_area * inverse_gradient);
  }

private:
  Matrix gradient_of_place, inverse_gradient;
  Number change_of_volume;
};
using Kinematics = KinematicsOf<double>;

template <typename Number>
KinematicsOf<Number>::KinematicsOf(const Matrix &displacement_gradient)
    : gradient_of_place(displacement_gradient +
                        static_cast<Matrix>(dealii::unit_symmetric_tensor<3, Number>()))
{
  // det(1 + H) - 1 by the invariants of H.
  const Matrix &h = displacement_gradient;
  const Number first = trace(h);
  change_of_volume = first + 0.5 * (first * first - trace(h * h)) + determinant(h);
  if constexpr (std::is_same_v<Number, double>)
    if (volume_ratio() == 0.)
      return;
  inverse_gradient = invert(gradient_of_place);
}

/// The 3x3 gradient of a vector from its gradient in the plane or in space and, in axisymmetry, its
/// radial component over the radius.
template <int dim, typename Number = double>
dealii::Tensor<2, 3, Number> whole_gradient(const dealii::Tensor<2, dim, Number> &gradient,
                                            const Number &hoop)
{
  dealii::Tensor<2, 3, Number> result;
  for (unsigned int c = 0; c < dim; ++c)
    for (unsigned int d = 0; d < dim; ++d)
      result[c][d] = gradient[c][d];
  if (dim == 2)
    result[2][2] = hoop;
  return result;
}
} // namespace Continua

#endif
