#include <continua/finite_element/solvers/harmonic_coefficients.h>

namespace Continua
{
HarmonicCoefficients harmonic_coefficients(const std::vector<Material> &materials,
                                           const std::complex<double> s)
{
  const std::complex<double> omega = std::complex<double>(0., -1.) * s;
  HarmonicCoefficients result;
  for (const Material &material : materials)
  {
    result.mass.push_back(s * s * material.density);
    result.stiffness.push_back(material.complex_shear_modulus(omega));
    result.compressibility.push_back(material.complex_inverse_bulk_modulus(omega));
  }
  result.support_damping = s;
  return result;
}
} // namespace Continua
