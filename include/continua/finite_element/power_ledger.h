#ifndef continua_finite_element_power_ledger_h
#define continua_finite_element_power_ledger_h

#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/boundary_constraints.h>
#include <continua/finite_element/field_evaluation.h>
#include <continua/finite_element/loads.h>
#include <continua/finite_element/region_operators.h>

#include <vector>

namespace Continua
{
/// What a step has balanced, all at its balance time; owned vectors.
struct BalancedStep
{
  Step step;
  DistributedVector velocity;     ///< [m/s]
  DistributedVector pressure;     ///< the unknown p [Pa]
  DistributedVector acceleration; ///< dU/dt as the scheme has it [m/s^2]
  DistributedVector prescribed;   ///< g: prescribed velocities at constrained dofs [m/s]
};

/**
 * Powers and energies from the matrices of the scheme itself, at the level at which it balances
 * them, so that the balance closes to the round-off of the solve.
 */
template <int dim>
class PowerLedger
{
public:
  PowerLedger(const Space<dim> &space,
              const Problem &problem,
              const std::vector<RegionOperators> &operators,
              const BoundaryConstraints<dim> &constraints,
              const Loads<dim> &loads);

  /// The mesh has changed.
  void reinit();
  /// `history` holds the internal displacements at the balanced level.
  PowerBalance balance(const BalancedStep &step, const BranchHistory &history);
  Energy energy(const State<dim> &state);

private:
  const Space<dim> &space;
  const Problem &problem;
  const std::vector<RegionOperators> &operators;
  const BoundaryConstraints<dim> &constraints;
  const Loads<dim> &loads;
  DistributedVector nodal_forces, velocity_work, mixture, pressure_work;
};
} // namespace Continua

#endif
