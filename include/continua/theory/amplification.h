#ifndef continua_theory_amplification_h
#define continua_theory_amplification_h

#include <continua/theory/complex_bessel.h>
#include <continua/time_integration/step.h>

#include <vector>

namespace Continua
{
/**
 * What a step does to one undamped mode dU/dt = -omega^2 D, dD/dt = U, of a Hookean solid or of a
 * compressible fluid (whose pressure follows the velocity by the same update): the eigenvalues G of
 * the map from the state before the step to the one after it, with the coefficients that the solver
 * uses. A step of two levels repeated with the same size has four (backward differencing with
 * trapezoidal update three, and a zero), one of one level two and two zeros.
 *
 * With theta = omega dt: implicit Euler |G| = (1 + theta^2)^(-1/2), with trapezoidal update (1 +
 * theta^2/2)^(-1/2) for theta <= 4, beyond which G is real and one tends to -1; Crank-Nicolson 1.
 */
class Amplification
{
public:
  /// `angular_frequency` omega [1/s], positive.
  Amplification(const Step &step, double angular_frequency);
  /// Of the displacement form, whose second derivative is Euler's (D - 2 D_o + D_oo)/dt^2 (3.42),
  /// or that of second order over four levels (2 D - 5 D_o + 4 D_oo - D_ooo)/dt^2 (3.43), with
  /// steps of `size` [s]. Euler's is G = 1/(1 -+ i theta).
  static Amplification
  of_displacement_form(double size, bool four_levels, double angular_frequency);

  /// The eigenvalues, the largest first.
  const std::vector<Complex> &factors() const { return eigenvalues; }
  /// Largest |G|: what is left after many steps whatever the start was.
  double spectral_radius() const { return std::abs(eigenvalues.front()); }
  /// The eigenvalue of the wave, at any theta: the largest with a positive imaginary part, or where
  /// all are real the largest.
  Complex of_wave() const;
  /// Whether the part that lasts longest changes its sign from step to step.
  bool rings() const;
  /// The eigenvalue closest to the exact factor exp(i omega dt): that of the mode as it should be.
  Complex principal() const;
  /// Part of the mode's amplitude that is left after `time` [s]: |principal|^(time/dt).
  double remaining(double time) const;
  /// Relative error of the mode's frequency: arg(principal) / theta - 1; negative is too slow.
  double frequency_error() const;

private:
  Amplification(double duration, double theta, std::vector<Complex> eigenvalues);
  double duration, theta;
  std::vector<Complex> eigenvalues;
};
} // namespace Continua

#endif
