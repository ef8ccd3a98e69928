#ifndef continua_continuum_right_stretch_h
#define continua_continuum_right_stretch_h

#include <deal.II/base/tensor.h>

#include <array>

namespace Continua
{
/// U of the polar decomposition F = R U with a rotation R: what a deformation is but for the turn.
class RightStretch
{
public:
  /// det F has to be positive.
  explicit RightStretch(const dealii::Tensor<2, 3> &deformation_gradient);

  /// U^-1 [1].
  const dealii::Tensor<2, 3> &inverse() const { return inverse_stretch; }
  /// dU for a change of F [1].
  dealii::Tensor<2, 3> change(const dealii::Tensor<2, 3> &of_deformation_gradient) const;

private:
  dealii::Tensor<2, 3> gradient, inverse_stretch;
  dealii::Tensor<2, 3> directions; ///< eigenvectors of U as rows
  std::array<double, 3> stretches;
};
} // namespace Continua

#endif
