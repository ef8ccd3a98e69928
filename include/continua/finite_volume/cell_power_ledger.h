#ifndef continua_finite_volume_cell_power_ledger_h
#define continua_finite_volume_cell_power_ledger_h

#include <continua/continuum/bulk_history.h>
#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state.h>
#include <continua/finite_volume/cell_loads.h>
#include <continua/finite_volume/cell_operators.h>

#include <vector>

namespace Continua
{
/// What a step has balanced, all at its balance time; owned vectors.
struct BalancedCells
{
  Step step;
  DistributedVector velocity;     ///< [m/s]
  DistributedVector pressure;     ///< the unknown p [Pa]
  DistributedVector acceleration; ///< as the scheme has it [m/s^2]
  DistributedVector prescribed;   ///< velocities in prescribed directions [m/s]
};

/**
 * Powers and energies of the cell-wise path. With `Power operator = scheme` they are the equations
 * of the scheme times the velocities of cells and faces, at the level at which it balances them, so
 * that the balance closes to the round-off of the solve. With compact or wide they are what the
 * thesis plots (equations 4.17 to 4.21): the kinetic power is the change of the kinetic energy, and
 * the stress is the compact or the wide operator's of the whole displacement, so that the residual
 * shows what the scheme loses and what its stencils differ by.
 */
template <int dim>
class CellPowerLedger
{
public:
  CellPowerLedger(const CellSpace<dim> &space,
                  const Problem &problem,
                  const CellWiseParameters &parameters,
                  const FaceConditions<dim> &conditions,
                  const CellLoads<dim> &loads,
                  const std::vector<CellOperators> &operators);

  /// The mesh has changed.
  void reinit();
  /// `start` and `end`: the velocities at the step's ends. The histories have just made the step.
  PowerBalance balance(const BalancedCells &step,
                       const DistributedVector &start,
                       const DistributedVector &end,
                       const BranchHistory &history,
                       const BulkHistory &bulk_history,
                       bool relaxation);
  Energy energy(const State &state, const BulkHistory &bulk_history);

private:
  const CellSpace<dim> &space;
  const Problem &problem;
  const CellWiseParameters &parameters;
  const FaceConditions<dim> &conditions;
  const CellLoads<dim> &loads;
  const std::vector<CellOperators> &operators;
  DistributedVector forces, velocity_work, mixture, other, pressure_work, dilatation;

  /// The forces of the branches' stress, as the scheme has them, into velocity_work.
  void
  set_stress_forces(unsigned int region, const BalancedCells &step, const BranchHistory &history);
  double relaxation_power(unsigned int region,
                          const BalancedCells &step,
                          const BranchHistory &history,
                          const BulkHistory &bulk_history);
  /// This rank's sum over its cells of p times weight times q.
  double pressure_product(const DistributedVector &p,
                          const DistributedVector &weight,
                          const DistributedVector &q) const;
};
} // namespace Continua

#endif
