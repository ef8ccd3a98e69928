#ifndef continua_base_deviatoric_part_h
#define continua_base_deviatoric_part_h

#include <deal.II/base/symmetric_tensor.h>

namespace Continua
{
/// dev t = t - 1/3 tr(t) 1, also of several points at once, which deal.II's deviator() does not
/// take.
template <typename Number>
dealii::SymmetricTensor<2, 3, Number>
deviatoric_part(const dealii::SymmetricTensor<2, 3, Number> &tensor)
{
  dealii::SymmetricTensor<2, 3, Number> result = tensor;
  const Number mean = trace(tensor) / 3.;
  for (unsigned int i = 0; i < 3; ++i)
    result[i][i] -= mean;
  return result;
}
} // namespace Continua

#endif
