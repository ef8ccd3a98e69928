#include <continua/materials/isochoric_stress.h>

namespace Continua
{
using namespace dealii;

SymmetricTensor<4, 3> isochoric_tangent(const double fictitious_trace,
                                        const SymmetricTensor<2, 3> &stress)
{
  const SymmetricTensor<2, 3> one = unit_symmetric_tensor<3>();
  return 2. / 3. *
         (fictitious_trace * deviator_tensor<3>() - outer_product(stress, one) -
          outer_product(one, stress));
}

SymmetricTensor<4, 3> deviator_of_both(const SymmetricTensor<4, 3> &tensor)
{
  const SymmetricTensor<2, 3> one = unit_symmetric_tensor<3>();
  const SymmetricTensor<2, 3> half = 1. / 3. * (tensor * one) - trace(tensor * one) / 18. * one;
  return tensor - outer_product(half, one) - outer_product(one, half);
}

SymmetricTensor<2, 3> square(const SymmetricTensor<2, 3> &b)
{
  return symmetrize(Tensor<2, 3>(b) * Tensor<2, 3>(b));
}

SymmetricTensor<4, 3> both_sides_product(const SymmetricTensor<2, 3> &b)
{
  SymmetricTensor<4, 3> result;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = i; j < 3; ++j)
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int l = k; l < 3; ++l)
          result[i][j][k][l] = 0.5 * (b[i][k] * b[j][l] + b[i][l] * b[j][k]);
  return result;
}
} // namespace Continua
