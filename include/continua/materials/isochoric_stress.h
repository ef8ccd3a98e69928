#ifndef continua_materials_isochoric_stress_h
#define continua_materials_isochoric_stress_h

#include <deal.II/base/symmetric_tensor.h>

namespace Continua
{
/// Places in a symmetric tensor in deal.II's order: 00, 11, 22, 01, 02, 12.
namespace SymmetricPlaces
{
constexpr unsigned int n = 6;
constexpr unsigned int row[n] = {0, 1, 2, 0, 0, 1};
constexpr unsigned int column[n] = {0, 1, 2, 1, 2, 2};
} // namespace SymmetricPlaces

/// a x b; deal.II's outer_product() takes three times as long.
template <typename Number>
dealii::SymmetricTensor<4, 3, Number> dyadic_product(const dealii::SymmetricTensor<2, 3, Number> &a,
                                                     const dealii::SymmetricTensor<2, 3, Number> &b)
{
  using SymmetricPlaces::n;
  dealii::SymmetricTensor<4, 3, Number> result;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      result.access_raw_entry(n * i + j) = a.access_raw_entry(i) * b.access_raw_entry(j);
  return result;
}

/**
 * The tangent C [Pa] of StrainLaw for a stress tau = dev(t) that depends on J^-1/3 F alone, where
 * the fictitious stress t [Pa] changes by dt = c : e + g t + t g^T:
 *
 *   C = 2/3 (tr(t) P - tau x 1 - 1 x tau) + P : c : P,   P = I - 1/3 1 x 1
 *
 * (Holzapfel, Nonlinear Solid Mechanics (2000), section 6.6). This is the part without c.
 */
template <typename Number>
dealii::SymmetricTensor<4, 3, Number>
isochoric_tangent(const Number &fictitious_trace,
                  const dealii::SymmetricTensor<2, 3, Number> &stress)
{
  using SymmetricPlaces::n;
  dealii::SymmetricTensor<4, 3, Number> result =
      (2. / 3. * fictitious_trace) * dealii::identity_tensor<3, Number>();
  // The part of P and both products have entries where a pair of equal indices stands.
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < 3; ++j)
    {
      const Number part = 2. / 3. * stress.access_raw_entry(i);
      result.access_raw_entry(n * i + j) -= part;
      result.access_raw_entry(n * j + i) -= part;
      if (i < 3)
        result.access_raw_entry(n * i + j) -= 2. / 9. * fictitious_trace;
    }
  return result;
}

/// P : c : P of a tensor with major symmetry.
template <typename Number>
dealii::SymmetricTensor<4, 3, Number>
deviator_of_both(const dealii::SymmetricTensor<4, 3, Number> &tensor)
{
  const dealii::SymmetricTensor<2, 3, Number> one = dealii::unit_symmetric_tensor<3, Number>();
  const dealii::SymmetricTensor<2, 3, Number> half =
      1. / 3. * (tensor * one) - trace(tensor * one) / 18. * one;
  return tensor - dyadic_product(half, one) - dyadic_product(one, half);
}

/// b b, where deal.II's product of two symmetric tensors is b : b.
template <typename Number>
dealii::SymmetricTensor<2, 3, Number> square(const dealii::SymmetricTensor<2, 3, Number> &b)
{
  const dealii::Tensor<2, 3, Number> tensor(b);
  return symmetrize(tensor * tensor);
}

/// The tensor c with c : e = b e b.
template <typename Number>
dealii::SymmetricTensor<4, 3, Number>
both_sides_product(const dealii::SymmetricTensor<2, 3, Number> &symmetric)
{
  const dealii::Tensor<2, 3, Number> b(symmetric);
  dealii::SymmetricTensor<4, 3, Number> result;
  for (unsigned int m = 0; m < SymmetricPlaces::n; ++m)
    for (unsigned int n = 0; n < SymmetricPlaces::n; ++n)
    {
      const unsigned int i = SymmetricPlaces::row[m], j = SymmetricPlaces::column[m],
                         k = SymmetricPlaces::row[n], l = SymmetricPlaces::column[n];
      result.access_raw_entry(SymmetricPlaces::n * m + n) =
          0.5 * (b[i][k] * b[j][l] + b[i][l] * b[j][k]);
    }
  return result;
}
} // namespace Continua

#endif
