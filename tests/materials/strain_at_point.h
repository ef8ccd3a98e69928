#ifndef continua_tests_materials_strain_at_point_h
#define continua_tests_materials_strain_at_point_h

// Deformations for the tests of laws at a point, the same on every machine.

#include <continua/materials/strain_law.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace strain_at_point
{
using Tensor2 = dealii::Tensor<2, 3>;
using Symmetric2 = dealii::SymmetricTensor<2, 3>;

inline Tensor2 unit_tensor()
{
  return Tensor2(dealii::unit_symmetric_tensor<3>());
}

/// Entries evenly between -size and size.
inline Tensor2 random_tensor(std::mt19937 &random, const double size)
{
  Tensor2 result;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      result[i][j] = size * (static_cast<double>(random()) / 2147483647.5 - 1.);
  return result;
}

/// A rotation by the Cayley transform of a skew tensor.
inline Tensor2 random_rotation(std::mt19937 &random)
{
  const Tensor2 any = random_tensor(random, 1.);
  const Tensor2 skew = any - transpose(any);
  return (unit_tensor() + skew) * invert(unit_tensor() - skew);
}

inline Continua::PointStrain strain_of(const Tensor2 &gradient,
                                       const std::vector<dealii::Tensor<1, 3>> &fibres = {})
{
  return {gradient, determinant(gradient), fibres};
}

/// d f(h)/dh at h = 0 by differences of fourth order.
template <typename Value>
Value derivative(const std::function<Value(double)> &f)
{
  constexpr double h = 1e-3;
  return (8. * (f(h) - f(-h)) - (f(2. * h) - f(-2. * h))) / (12. * h);
}

/// C : e + g tau + tau g^T.
inline Symmetric2 stress_change(const dealii::SymmetricTensor<4, 3> &tangent,
                                const Symmetric2 &stress,
                                const Tensor2 &g)
{
  return tangent * symmetrize(g) + 2. * symmetrize(g * stress);
}
} // namespace strain_at_point

#endif
