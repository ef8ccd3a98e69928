#include <continua/materials/mean_modulus.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace Continua
{
using dealii::numbers::PI;

double
mean_modulus(const Material &material, const double fundamental, const unsigned int n_harmonics)
{
  double sum = 0.;
  for (unsigned int i = 1; i <= n_harmonics; ++i)
    sum += material.complex_young_modulus(2. * PI * fundamental * i).real();
  return sum / n_harmonics;
}
} // namespace Continua
