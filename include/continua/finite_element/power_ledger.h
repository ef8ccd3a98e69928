#ifndef continua_finite_element_power_ledger_h
#define continua_finite_element_power_ledger_h

#include <continua/continuum/bulk_history.h>
#include <continua/continuum/continuum_solver.h>
#include <continua/continuum/problem.h>
#include <continua/finite_element/boundary_constraints.h>
#include <continua/finite_element/field_evaluation.h>
#include <continua/finite_element/loads.h>
#include <continua/finite_element/outlet_coupling.h>
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
              const Loads<dim> &loads,
              const OutletCoupling<dim> &outlets);

  /// The mesh has changed.
  void reinit();
  /// The histories have just made the step. `relaxation`: also the power that relaxation turns into
  /// heat, at the cost of a product for each branch that relaxes.
  PowerBalance balance(const BalancedStep &step,
                       const BranchHistory &history,
                       const BulkHistory &bulk_history,
                       bool relaxation);
  Energy energy(const State &state, const BulkHistory &bulk_history);

private:
  const Space<dim> &space;
  const Problem &problem;
  const std::vector<RegionOperators> &operators;
  const BoundaryConstraints<dim> &constraints;
  const Loads<dim> &loads;
  const OutletCoupling<dim> &outlets;
  DistributedVector nodal_forces, velocity_work, mixture, forgotten, pressure_work, dilatation,
      forgotten_rate;

  /// This rank's part of what relaxation turns into heat in a region: sum of mu_k D_k S (U -
  /// dD_k/dt) and K_k e_k M_p (d - de_k/dt), at the balanced level [W].
  double relaxation_power(unsigned int region,
                          const BalancedStep &step,
                          const BranchHistory &history,
                          const BulkHistory &bulk_history);
};
} // namespace Continua

#endif
