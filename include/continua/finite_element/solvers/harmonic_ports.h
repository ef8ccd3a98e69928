#ifndef continua_finite_element_solvers_harmonic_ports_h
#define continua_finite_element_solvers_harmonic_ports_h

#include <continua/continuum/problem.h>

#include <deal.II/lac/full_matrix.h>

#include <complex>
#include <vector>

namespace Continua
{
/**
 * The pressures P of the ports of a body in motion exp(s t). Each port pushes with -q P, q_i = int
 * v_i . n. With the flow rates Q_0 that there are without these pressures, and H, the flow rates by
 * a pressure of 1 Pa at each port,
 *
 *   Q = Q_0 + H P,   P = Z(s) Q + pressures behind   of outlets,
 *                    Q = -given                      of free flow rates.
 */
class HarmonicPorts
{
public:
  using Complex = std::complex<double>;

  /// The problem must outlive it.
  explicit HarmonicPorts(const Problem &problem);

  /// By port; those of an outlet stand one behind the other.
  const std::vector<unsigned int> &conditions() const { return of_ports; }
  unsigned int size() const { return of_ports.size(); }
  bool is_free_flow(const unsigned int port) const { return port >= n_of_outlets; }

  /// Z(s) [Pa s/m^3]; 0 of free flow rates.
  dealii::FullMatrix<Complex> impedances(Complex s) const;
  /// Takes H [m^3/(s Pa)] at s.
  void set_responses(Complex s, const dealii::FullMatrix<Complex> &responses);
  /// P of Q_0; `given`: pressures behind, and flow rates into the body.
  std::vector<Complex> pressures(const std::vector<Complex> &flow_rates,
                                 const std::vector<Complex> &given) const;
  /// By which the ports multiply the determinant of the body alone, the equation of a free flow
  /// rate being that of the displacement, int u . n = given/s.
  Complex log_determinant() const { return logarithm; }

private:
  const Problem &problem;
  std::vector<unsigned int> of_ports;
  unsigned int n_of_outlets = 0;
  dealii::FullMatrix<Complex> impedance, inverse;
  Complex logarithm;
};
} // namespace Continua

#endif
