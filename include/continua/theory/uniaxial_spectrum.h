#ifndef continua_theory_uniaxial_spectrum_h
#define continua_theory_uniaxial_spectrum_h

#include <complex>
#include <vector>

namespace Continua
{
/**
 * f(s) = a + sum_j b_j/(s + r_j) with a >= 0, b_j > 0 and rates r_j >= 0 [1/s]: a Stieltjes
 * function of the Laplace variable s with finitely many poles. Springs and dash pots, however they
 * are put together, make such functions: a modulus over s, or a compliance. It is the transform of
 * a delta function of strength a and of decaying exponentials.
 */
class UniaxialSpectrum
{
public:
  struct Line
  {
    double weight; ///< b [unit of f times 1/s]
    double rate;   ///< r [1/s]
  };

  explicit UniaxialSpectrum(double constant = 0.);

  /// Adds b/(s + r); lines of equal rates become one.
  void add(double weight, double rate);
  void add(double factor, const UniaxialSpectrum &other);

  /**
   * 1/(s f(s)), a Stieltjes function again: the compliance of a modulus over s and the other way
   * round. Its poles are the zeros of s f(s), of which there is exactly one between two poles of f
   * (and one beyond the last if a > 0), each found in its bracket. f must not be 0.
   */
  UniaxialSpectrum inverse() const;

  double constant() const { return a; }
  const std::vector<Line> &lines() const { return sum; } ///< by ascending rate
  std::complex<double> operator()(const std::complex<double> &s) const;
  /// sum_j b_j exp(-r_j t): the transform's original but for the delta function [unit of f times
  /// 1/s].
  double decay(double time) const;
  /// a + sum_j b_j (1 - exp(-r_j t))/r_j: the integral of the original from 0, with the delta
  /// function; 0 for negative times.
  double integral(double time) const;

private:
  double a;
  std::vector<Line> sum;
};
} // namespace Continua

#endif
