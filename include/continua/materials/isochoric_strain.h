#ifndef continua_materials_isochoric_strain_h
#define continua_materials_isochoric_strain_h

#include <continua/base/of_each.h>
#include <continua/materials/strain_law.h>

#include <cmath>

namespace Continua
{
/// F - 1.
template <typename Number>
dealii::Tensor<2, 3, Number> displacement_gradient(const dealii::Tensor<2, 3, Number> &gradient)
{
  dealii::Tensor<2, 3, Number> result = gradient;
  for (unsigned int i = 0; i < 3; ++i)
    result[i][i] -= 1.;
  return result;
}

/// F^T F - 1 [1] without the round-off of F^T F at small strains.
template <typename Number>
dealii::SymmetricTensor<2, 3, Number>
twice_green_strain(const dealii::Tensor<2, 3, Number> &gradient)
{
  const dealii::Tensor<2, 3, Number> g = displacement_gradient(gradient);
  return 2. * symmetrize(g) + symmetrize(transpose(g) * g);
}

/// The part of a deformation that changes the shape: J^-1/3 F.
template <typename Number>
class IsochoricStrainOf
{
public:
  explicit IsochoricStrainOf(const PointStrainOf<Number> &strain);

  Number factor;                              ///< J^-2/3 [1]
  dealii::SymmetricTensor<2, 3, Number> left; ///< Bb = J^-2/3 F F^T [1]
  /// tr Bb - 3 [1], of second order in the strain: its relative round-off at a strain e is that of
  /// F over e, where the difference itself would lose e^2.
  Number first_excess;

  /// (tr^2 Bb - tr Bb^2)/2 - 3 [1], to the same accuracy.
  Number second_excess() const
  {
    return 2. * first_excess + 0.5 * (first_excess * first_excess - left_excess * left_excess);
  }

private:
  dealii::SymmetricTensor<2, 3, Number> left_excess; ///< Bb - 1

  /// det(1 + G) - 1 by the invariants of G.
  static Number volume_excess(const dealii::Tensor<2, 3, Number> &g)
  {
    const Number trace_of_square = scalar_product(g, transpose(g));
    return trace(g) + 0.5 * (trace(g) * trace(g) - trace_of_square) + determinant(g);
  }
};
using IsochoricStrain = IsochoricStrainOf<double>;

template <typename Number>
IsochoricStrainOf<Number>::IsochoricStrainOf(const PointStrainOf<Number> &strain)
    : factor(of_each([](const double j) { return 1. / std::cbrt(j * j); }, strain.determinant))
{
  const dealii::Tensor<2, 3, Number> g = displacement_gradient(strain.gradient);
  // Bb - 1 = J^-2/3 (F F^T - 1 - (J^2/3 - 1)).
  left_excess = 2. * symmetrize(g) + symmetrize(g * transpose(g));
  const Number stretch_excess =
      of_each([](const double of_volume) { return std::expm1(2. / 3. * std::log1p(of_volume)); },
              volume_excess(g));
  for (unsigned int i = 0; i < 3; ++i)
    left_excess[i][i] -= stretch_excess;
  left_excess *= factor;
  left = left_excess;
  for (unsigned int i = 0; i < 3; ++i)
    left[i][i] += 1.;
  first_excess = trace(left_excess);
}
} // namespace Continua

#endif
