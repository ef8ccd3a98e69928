#ifndef continua_continuum_newton_convergence_h
#define continua_continuum_newton_convergence_h

#include <continua/continuum/newton_residual.h>
#include <continua/continuum/nonlinear_system.h>
#include <continua/continuum/problem.h>
#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/// Judges the iterates of Newton's iteration in one step: whether the equations hold, and how the
/// residual falls. See Newton for the rules.
class NewtonConvergence
{
public:
  /// `parameters` must outlive it.
  explicit NewtonConvergence(const NewtonParameters &parameters) : parameters(parameters) {}

  /// Takes the residuals of the next iterate; `of_cavities`: the largest part by which a volume of
  /// a cavity differs from the one given [1].
  void take(const ResidualNorms &norms, double of_cavities);
  /// The largest residual of the iterate, by the largest one of the step, or of a cavity [1].
  double residual() const { return present.residual; }
  /// Sizes of the residuals that matter: that of the iterate, or what is accepted [N], [m^3/s].
  ResidualScales scales() const;

  /// Whether the residual falls too slowly.
  bool is_slow() const;
  bool is_finite() const;
  /// Whether momentum is at round-off and a correction with the exact derivative has not halved the
  /// residual of volume. `correction_is_exact`: the last one had the exact derivative.
  bool volume_stays(bool correction_is_exact) const;
  /// `volume_is_round_off`: the residual of volume counts as that of a pressure.
  bool is_solved(bool volume_is_round_off) const;

  /// Throws StepFailure, or RunError where no shorter step can help. `momentum`, `mass`: the
  /// residuals. Collective.
  [[noreturn]] void fail(const Problem &problem,
                         const NonlinearSystem &terms,
                         const DistributedVector &momentum,
                         const DistributedVector &mass) const;

private:
  struct Iterate
  {
    ResidualNorms norms;
    double accepted_momentum = 0., accepted_mass = 0.; ///< [N], [m^3/s]
    double of_momentum = 0., of_mass = 0.; ///< by the largest of the step; round-off counts as 0
    double of_cavities = 0., residual = 0.;
    bool momentum_is_round_off = false;
  };

  const NewtonParameters &parameters;
  Iterate previous, present;
  unsigned int n_iterates = 0;
  double largest_momentum = 0., largest_mass = 0.; ///< of the step [N], [m^3/s]
};
} // namespace Continua

#endif
