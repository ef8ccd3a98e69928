#ifndef continua_theory_uniaxial_response_h
#define continua_theory_uniaxial_response_h

#include <continua/materials/material.h>
#include <continua/theory/uniaxial_spectrum.h>

#include <complex>

namespace Continua
{
/**
 * The exact answer of a bar without inertia, stretched along its axis and free at its sides, to the
 * loads of the material tests. With s the Laplace variable,
 *
 * mu(s) = s eta + sum_k mu_k s/(s + 1/tau_k), K(s) = K or sum_k K_k s/(s + 1/tau_k), compliance
 * J(s) = 1/(3 mu(s)) + 1/(9 K(s)) and modulus Y(s) = 1/J(s) = 9 K mu/(3 K + mu).
 *
 * Both are rational functions of s whose partial fractions UniaxialSpectrum finds, so that every
 * answer is a finite sum of exponentials. Strain and stress are those of small deformations.
 */
class UniaxialResponse
{
public:
  /// Of a solid by its branches; a power law must have been given branches.
  explicit UniaxialResponse(const Material &material);

  /// Y(i omega) [Pa], omega [1/s].
  std::complex<double> modulus(double omega) const;

  /// Stress [Pa] at a time [s] > 0, of a strain that rises evenly from 0 at t = 0 to `strain`
  /// within `loading_time` [s] > 0 and is then held. At the end of the loading, where a dash pot
  /// makes the stress jump, that before the jump.
  double ramp_stress(double strain, double loading_time, double time) const;
  /// Strain at a time [s] > 0 of a stress [Pa] that is there from t = 0 on.
  double step_strain(double stress, double time) const;
  /// Stress [Pa] at a time [s] > 0 of the strain `amplitude` sin(omega t) from t = 0 on, the start
  /// included.
  double sine_stress(double amplitude, double omega, double time) const;

  /// Y(s)/s [Pa s]: its lines are the relaxation modulus, sum_j Y_j exp(-r_j t), its constant a
  /// dash pot.
  const UniaxialSpectrum &relaxation() const { return relaxation_spectrum; }
  /// J(s) [1/Pa]: its constant is the elastic compliance, its lines are creep.
  const UniaxialSpectrum &creep() const { return creep_spectrum; }

private:
  UniaxialSpectrum creep_spectrum, relaxation_spectrum;
};

/// The same for the power law Y(t) = c (t/1 s)^-n itself (equation 5.2 of the thesis), c [Pa], 0 <
/// n < 1.
struct PowerLawResponse
{
  double c = 0.;
  double n = 0.;

  /// c Gamma(1 - n) (i omega)^n (5.6) [Pa].
  std::complex<double> modulus(double omega) const;
  /// As UniaxialResponse's: the Boltzmann integral (5.1) of the ramp.
  double ramp_stress(double strain, double loading_time, double time) const;
  /// stress t^n sin(n pi)/(n pi c), since Y(s) J(s) = 1 and Gamma(1 - n) Gamma(1 + n) = n pi/sin(n
  /// pi).
  double step_strain(double stress, double time) const;
};
} // namespace Continua

#endif
