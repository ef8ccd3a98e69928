#include <continua/continuum/right_stretch.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

RightStretch::RightStretch(const Tensor<2, 3> &deformation_gradient)
    : gradient(deformation_gradient)
{
  const auto pairs = eigenvectors(symmetrize(transpose(gradient) * gradient));
  for (unsigned int i = 0; i < 3; ++i)
  {
    stretches[i] = std::sqrt(pairs[i].first);
    directions[i] = pairs[i].second;
    inverse_stretch += 1. / stretches[i] * outer_product(directions[i], directions[i]);
  }
}

Tensor<2, 3> RightStretch::change(const Tensor<2, 3> &of_deformation_gradient) const
{
  // U dU + dU U = F^T dF + dF^T F.
  const Tensor<2, 3> half = transpose(gradient) * of_deformation_gradient;
  Tensor<2, 3> result = directions * (half + transpose(half)) * transpose(directions);
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      result[i][j] /= stretches[i] + stretches[j];
  return transpose(directions) * result * directions;
}
} // namespace Continua
