#ifndef continua_continuum_harmonic_derivatives_h
#define continua_continuum_harmonic_derivatives_h

#include <continua/continuum/harmonic_system.h>
#include <continua/continuum/problem.h>

#include <complex>
#include <vector>

namespace Continua
{
/// How a problem changes with a number m: d/dm of anything that follows from the problem is the sum
/// of weights times what each of a few problems has in its place.
struct ProblemChange
{
  std::vector<const Problem *> problems;
  std::vector<double> weights; ///< [1/unit of m]
  HarmonicLoad load;           ///< d/dm of the whole load of the motion
};

/**
 * Derivatives of numbers J that are linear in a motion exp(s t), by numbers m of the problem. With
 * the symmetric matrix A of HarmonicSystem, its solution U of A U = f and the adjoint one, A lambda
 * = g for J = g . U,
 *
 *   dJ/dm = dg/dm . U + lambda . (df/dm - dA/dm U).
 *
 * dA/dm is the sum of the regions' matrices times the derivatives of their coefficients, of which
 * alone differences are taken. The impedances of ports have to be symmetric.
 */
class HarmonicDerivatives
{
public:
  using Complex = std::complex<double>;
  virtual ~HarmonicDerivatives() = default;

  /// dJ/dm by functional and change; `adjoints`: the solution under the weights of each functional.
  /// Collective; throws RunError where ports answer each other in different ways.
  virtual std::vector<std::vector<Complex>>
  evaluate(const HarmonicSolution &solution,
           const std::vector<HarmonicFunctional> &functionals,
           const std::vector<HarmonicSolution> &adjoints) = 0;
};
} // namespace Continua

#endif
