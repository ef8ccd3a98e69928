#ifndef continua_continuum_steady_solve_h
#define continua_continuum_steady_solve_h

#include <continua/base/log.h>
#include <continua/continuum/operators.h>
#include <continua/continuum/outlet_coupling.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/step_right_side.h>

namespace Continua
{
/// The steady state of a linear body that is all solid or all fluid, by one solve without time.
class SteadySolve
{
public:
  /// All must outlive it.
  SteadySolve(const Problem &problem,
              Operators &operators,
              OutletCoupling &outlets,
              StepRightSide &right_side,
              Log &log);

  /// Whether there is such a solve for the body.
  bool applies() const;
  /// Whether it gives the displacement [m] of a body at rest, and not the velocity [m/s] of a flow.
  bool is_of_solids() const;
  /// Sets `solved`, which is one of these, and the pressure, with the loads at `time` [s]; and the
  /// prescribed velocities in `solution`. Throws RunError. Collective.
  void solve(double time,
             DistributedVector &solved,
             DistributedVector &pressure,
             StepSolution &solution);

private:
  const Problem &problem;
  Operators &operators;
  OutletCoupling &outlets;
  StepRightSide &right_side;
  Log &log;
};
} // namespace Continua

#endif
