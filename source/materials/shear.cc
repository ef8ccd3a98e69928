#include <continua/materials/shear.h>

#include <algorithm>
#include <cmath>

namespace Continua
{
std::complex<double> PowerLaw::young_modulus(const std::complex<double> &i_omega) const
{
  return modulus * std::tgamma(1. - exponent) * std::pow(i_omega, exponent);
}

bool Shear::relaxes() const
{
  return power_law ||
         std::any_of(branches.begin(), branches.end(),
                     [](const Branch &branch) { return !std::isinf(branch.relaxation_time); });
}

double Shear::long_term_modulus() const
{
  double sum = 0.;
  for (const Branch &branch : branches)
    if (std::isinf(branch.relaxation_time))
      sum += branch.shear_modulus;
  return sum;
}

double Shear::instantaneous_modulus() const
{
  double sum = 0.;
  for (const Branch &branch : branches)
    sum += branch.shear_modulus;
  return sum;
}
} // namespace Continua
