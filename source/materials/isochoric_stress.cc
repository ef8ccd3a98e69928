#include <continua/materials/isochoric_stress.h>

namespace Continua
{
using namespace dealii;

namespace
{
/// Places in a symmetric tensor in deal.II's order: 00, 11, 22, 01, 02, 12.
constexpr unsigned int n_places = 6;
constexpr unsigned int row_of_place[n_places] = {0, 1, 2, 0, 0, 1};
constexpr unsigned int column_of_place[n_places] = {0, 1, 2, 1, 2, 2};
} // namespace

SymmetricTensor<4, 3> dyadic_product(const SymmetricTensor<2, 3> &a, const SymmetricTensor<2, 3> &b)
{
  SymmetricTensor<4, 3> result;
  for (unsigned int i = 0; i < n_places; ++i)
    for (unsigned int j = 0; j < n_places; ++j)
      result.access_raw_entry(n_places * i + j) = a.access_raw_entry(i) * b.access_raw_entry(j);
  return result;
}

SymmetricTensor<4, 3> isochoric_tangent(const double fictitious_trace,
                                        const SymmetricTensor<2, 3> &stress)
{
  SymmetricTensor<4, 3> result = (2. / 3. * fictitious_trace) * identity_tensor<3>();
  // The part of P and both products have entries where a pair of equal indices stands.
  for (unsigned int i = 0; i < n_places; ++i)
    for (unsigned int j = 0; j < 3; ++j)
    {
      const double part = 2. / 3. * stress.access_raw_entry(i);
      result.access_raw_entry(n_places * i + j) -= part;
      result.access_raw_entry(n_places * j + i) -= part;
      if (i < 3)
        result.access_raw_entry(n_places * i + j) -= 2. / 9. * fictitious_trace;
    }
  return result;
}

SymmetricTensor<4, 3> deviator_of_both(const SymmetricTensor<4, 3> &tensor)
{
  const SymmetricTensor<2, 3> one = unit_symmetric_tensor<3>();
  const SymmetricTensor<2, 3> half = 1. / 3. * (tensor * one) - trace(tensor * one) / 18. * one;
  return tensor - dyadic_product(half, one) - dyadic_product(one, half);
}

SymmetricTensor<2, 3> square(const SymmetricTensor<2, 3> &b)
{
  return symmetrize(Tensor<2, 3>(b) * Tensor<2, 3>(b));
}

SymmetricTensor<4, 3> both_sides_product(const SymmetricTensor<2, 3> &symmetric)
{
  const Tensor<2, 3> b(symmetric);
  SymmetricTensor<4, 3> result;
  for (unsigned int m = 0; m < n_places; ++m)
    for (unsigned int n = 0; n < n_places; ++n)
    {
      const unsigned int i = row_of_place[m], j = column_of_place[m], k = row_of_place[n],
                         l = column_of_place[n];
      result.access_raw_entry(n_places * m + n) = 0.5 * (b[i][k] * b[j][l] + b[i][l] * b[j][k]);
    }
  return result;
}
} // namespace Continua
