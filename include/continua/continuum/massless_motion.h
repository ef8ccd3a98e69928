#ifndef continua_continuum_massless_motion_h
#define continua_continuum_massless_motion_h

#include <continua/continuum/branch_history.h>
#include <continua/continuum/bulk_history.h>
#include <continua/continuum/level_products.h>
#include <continua/continuum/operators.h>
#include <continua/continuum/outlet_coupling.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state_levels.h>

namespace Continua
{
/// Velocities without mass, where a discretisation has them: forces that are out of balance deform
/// the body there at once.
class MasslessMotion
{
public:
  /// All must outlive it.
  MasslessMotion(const Problem &problem,
                 Operators &operators,
                 BranchHistory &history,
                 BulkHistory &bulk_history,
                 OutletCoupling &outlets,
                 LevelProducts &products,
                 StateLevels &levels);

  /// The mesh has changed; zeros of its vectors.
  void reinit(const DistributedVector &zero_velocity, const DistributedVector &zero_pressure);
  /// Deforms by the forces that are out of balance in the state `present` at this time [s]: at the
  /// start, where the load is there at once, and on a new mesh.
  void deform_by_imbalance(double time, const State &present);
  /// Deforms by a load that jumps in the step, where the rule is trapezoidal.
  void deform_by_jump(const Step &step);

private:
  const Problem &problem;
  Operators &operators;
  BranchHistory &history;
  BulkHistory &bulk_history;
  OutletCoupling &outlets;
  LevelProducts &products;
  StateLevels &levels;
  DistributedVector forces, velocity_work, mixture, pressure_work;

  /// Deforms by `forces`.
  void deform();
};
} // namespace Continua

#endif
