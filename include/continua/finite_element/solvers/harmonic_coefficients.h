#ifndef continua_finite_element_solvers_harmonic_coefficients_h
#define continua_finite_element_solvers_harmonic_coefficients_h

#include <continua/materials/material.h>

#include <complex>
#include <vector>

namespace Continua
{
/// What the matrix of a motion exp(s t) is made of, by material id, for displacements.
struct HarmonicCoefficients
{
  using Complex = std::complex<double>;
  std::vector<Complex> mass;            ///< s^2 rho [kg/(m^3 s^2)]
  std::vector<Complex> stiffness;       ///< mu*(s) [Pa]
  std::vector<Complex> compressibility; ///< 1/K*(s) [1/Pa]
  /// Of a body under loads, see LoadedBody, whose stiffness above is that of its branches, and
  /// whose parts of mass and compression have density and modulus: s [1/s]. Else empty. Its mass
  /// above is s^2 [1/s^2], and its compressibility is empty.
  std::vector<Complex> viscosity;
  Complex support_stiffness = 1., support_damping = 0.; ///< [1], s [1/s]
};

/// Of a body without loads.
HarmonicCoefficients harmonic_coefficients(const std::vector<Material> &materials,
                                           std::complex<double> s);
} // namespace Continua

#endif
