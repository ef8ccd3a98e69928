#ifndef continua_continuum_known_pressure_h
#define continua_continuum_known_pressure_h

#include <continua/continuum/operators.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state_visitor.h>
#include <continua/continuum/step_solution.h>

#include <vector>

namespace Continua
{
/**
 * The pressure of incompressible materials, which has no history where 1/K = 0: that of a step
 * belongs to the time at which its equations are balanced, and the line through the last two of
 * them leads to the end of the step.
 */
class KnownPressure
{
public:
  /// The mesh has changed. Collective.
  void reinit(const Problem &problem, const Operators &operators);
  /// The run begins with this pressure [Pa] at t = 0.
  void start(const DistributedVector &pressure);
  /// Sets the pressure at the end of a step that extrapolates, where there are such materials.
  void extrapolate(const Step &step,
                   const DistributedVector &of_step,
                   DistributedVector &pressure) const;
  /// The step has ended with this pressure at its balance time.
  void take(const Step &step, const DistributedVector &of_step);
  void visit(StateVisitor &visitor);

private:
  DistributedVector known;           ///< [Pa], at `time`
  double time = 0.;                  ///< [s]
  std::vector<unsigned int> entries; ///< of such pressures, local indices
  bool some_rank_has_entries = false;
};
} // namespace Continua

#endif
