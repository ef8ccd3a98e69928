#ifndef continua_continuum_ledger_h
#define continua_continuum_ledger_h

#include <continua/continuum/equation_term.h>
#include <continua/continuum/outlet_coupling.h>
#include <continua/continuum/power_balance.h>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace Continua
{
/**
 * Powers and energies of the terms of the equations, from the operators of the scheme itself at the
 * level at which it balances them, so that the balance closes to the round-off of the solve. (The
 * cell-wise path can also report what the thesis plots, equations 4.17 to 4.21: then the residual
 * shows what its scheme loses.)
 */
class Ledger
{
public:
  /// All must outlive it. `products`: of the levels of the state; null where they are not kept.
  Ledger(const Problem &problem,
         Operators &operators,
         const OutletCoupling &outlets,
         const BranchHistory &history,
         const BulkHistory &bulk_history,
         LevelProducts *products = nullptr);

  /// The mesh has changed.
  void reinit();
  /// Of the step that the histories have just made. `relaxation`: also the power that relaxation
  /// turns into heat.
  PowerBalance balance(const FinishedStep &step, bool relaxation);
  Energy energy(const State &state);

  /// Makes balance() keep the forces at the nodes, too, and those of each of these regions.
  void want_forces(const std::set<unsigned int> &regions);
  /// What the equations of a step leave at the nodes, inertia + inner forces + convection - loads
  /// [N]: the forces that move the nodes of prescribed velocity, and 0 up to the accuracy of the
  /// solution at free ones. Those of balance() if it has made them; zeros before the first step on
  /// a mesh. Of a region: what the equations of its cells alone leave, which at a free node is the
  /// force that the cells of other regions exert there. Collective.
  const DistributedVector &forces_at_nodes(const FinishedStep &step,
                                           std::optional<unsigned int> region);
  /// A step has been made, of which the forces are not known.
  void forget_forces() { forces_are_current = false; }

private:
  const Problem &problem;
  Operators &operators;
  const OutletCoupling &outlets;
  std::vector<std::unique_ptr<EquationTerm>> terms;
  TermContext context;
  StepSolution extrapolated; ///< with explicit convection: the state at the extrapolated velocity
  DistributedVector forces;
  std::map<unsigned int, DistributedVector> forces_of_regions; ///< that are wanted
  bool forces_are_wanted = false, forces_are_current = false;
  std::vector<double> sums; ///< work space

  /// Sets the context's nonlinear powers of a region, each kind at the level from which the step
  /// has taken it, and adds their forces [N] to `at_nodes` unless that is null.
  void set_nonlinear_powers(unsigned int region,
                            const StepSolution &solution,
                            DistributedVector *at_nodes);
};
} // namespace Continua

#endif
