#ifndef continua_theory_impedance_h
#define continua_theory_impedance_h

#include <deal.II/lac/full_matrix.h>

#include <complex>
#include <vector>

namespace Continua
{
/**
 * What pressures p_i [Pa] answer to flow rates Q_j [m^3/s] at the ports of an outlet, as a sum of
 * first-order responses:
 *
 *     p = direct Q + sum_k residue_k x_k,    dx_k/dt = Q - rate_k x_k,
 *
 * in harmonic motion Z(s) = direct + sum_k residue_k / (s + rate_k), s = i omega. All matrices are
 * real, symmetric and of the size of the number of ports, so that a step of the scheme treats x_k
 * as it does the internal displacement of a branch of the relaxation time 1/rate_k.
 */
// NOLINTNEXTLINE(bugprone-exception-escape): deal.II's matrix may throw when it is moved
struct Impedance
{
  using Complex = std::complex<double>;
  using Matrix = dealii::FullMatrix<double>;

  // NOLINTNEXTLINE(bugprone-exception-escape): deal.II's matrix may throw when it is moved
  struct Term
  {
    double rate = 0.; ///< [1/s], not negative
    Matrix residue;   ///< [Pa/m^3]
  };
  Matrix direct; ///< [Pa s/m^3]
  std::vector<Term> terms;
  /// Whether every term is an energy store of its own, 1/2 x residue x (a compliance); else what
  /// leaves cannot be told from what is stored.
  bool terms_store_energy = false;

  unsigned int n_ports() const { return direct.m(); }
  /// Z [Pa s/m^3] at s [1/s].
  dealii::FullMatrix<Complex> value(const Complex &s) const;

  /// p = R Q.
  static Impedance resistance(double resistance);
  /// The three-element windkessel: a resistance [Pa s/m^3] before a compliance [m^3/Pa] beside a
  /// second resistance, Z = R_p + R_d / (1 + s R_d C).
  static Impedance
  windkessel(double proximal_resistance, double distal_resistance, double compliance);
};
} // namespace Continua

#endif
