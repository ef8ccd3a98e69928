#include <continua/materials/isochoric_strain.h>

#include <cmath>

namespace Continua
{
using namespace dealii;

namespace
{
/// G = F - 1.
Tensor<2, 3> displacement_gradient(const Tensor<2, 3> &gradient)
{
  Tensor<2, 3> result = gradient;
  for (unsigned int i = 0; i < 3; ++i)
    result[i][i] -= 1.;
  return result;
}

/// det(1 + G) - 1 by the invariants of G.
double volume_excess(const Tensor<2, 3> &g)
{
  const double trace_of_square = scalar_product(g, transpose(g));
  return trace(g) + 0.5 * (trace(g) * trace(g) - trace_of_square) + determinant(g);
}
} // namespace

SymmetricTensor<2, 3> twice_green_strain(const Tensor<2, 3> &gradient)
{
  const Tensor<2, 3> g = displacement_gradient(gradient);
  return 2. * symmetrize(g) + symmetrize(transpose(g) * g);
}

IsochoricStrain::IsochoricStrain(const PointStrain &strain)
    : factor(1. / std::cbrt(strain.determinant * strain.determinant))
{
  const Tensor<2, 3> g = displacement_gradient(strain.gradient);
  // Bb - 1 = J^-2/3 (F F^T - 1 - (J^2/3 - 1)).
  left_excess = 2. * symmetrize(g) + symmetrize(g * transpose(g));
  const double stretch_excess = std::expm1(2. / 3. * std::log1p(volume_excess(g)));
  for (unsigned int i = 0; i < 3; ++i)
    left_excess[i][i] -= stretch_excess;
  left_excess *= factor;
  left = left_excess;
  for (unsigned int i = 0; i < 3; ++i)
    left[i][i] += 1.;
  first_excess = trace(left_excess);
}

double IsochoricStrain::second_excess() const
{
  return 2. * first_excess + 0.5 * (first_excess * first_excess - left_excess * left_excess);
}
} // namespace Continua
