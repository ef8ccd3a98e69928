#ifndef continua_continuum_level_products_h
#define continua_continuum_level_products_h

#include <continua/continuum/branch_history.h>
#include <continua/continuum/operators.h>
#include <continua/continuum/problem.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/time_integration/step.h>

#include <array>
#include <vector>

namespace Continua
{
/**
 * The products of the regions' matrices with the levels of the state, each made once: M v, S v and,
 * of springs that do not relax, S D, at the present time and one step before, and B v. What a step
 * balances and what the next one knows of the past are sums of these levels, so that the right-hand
 * side, the ledger and the energies are sums of these products.
 *
 * A product is made when it is first asked for, of the level itself. It is therefore the same, bit
 * by bit, whether it was kept since the step before or made after a restart.
 */
class LevelProducts
{
public:
  /// All must outlive it: the velocities of both levels, and the history with the displacements.
  LevelProducts(const Problem &problem,
                Operators &operators,
                const BranchHistory &history,
                const DistributedVector &velocity,
                const DistributedVector &velocity_older);

  /// The mesh has changed.
  void reinit();
  /// The levels are others than they were.
  void forget();
  void forget_older();
  /// From now on others than the steps change the state: nothing is kept any more.
  void share() { is_shared = true; }
  /// A step has ended: its start is the older level now.
  void advance();

  /// Whether the linear terms of a region are sums of these products, and nothing else.
  bool has(unsigned int region) const;
  /// Whether they hold what the last step balanced.
  bool has_step(const unsigned int region) const { return knows_step && has(region); }
  /// Whether the stress of the branches is S D of the displacement D, times spring().
  bool is_elastic(const unsigned int region) const
  {
    return has(region) && history.is_elastic(region);
  }
  double spring(const unsigned int region) const { return history.spring(region); } ///< [Pa]

  // At the present time.
  const DistributedVector &mass(unsigned int region);       ///< M v
  const DistributedVector &stiffness(unsigned int region);  ///< S D
  const DistributedVector &divergence(unsigned int region); ///< B v

  /// M (-a1 v - a2 v_older), what the inertia of a step from the present time has of the past. The
  /// step then ends with advance().
  const DistributedVector &past_inertia(unsigned int region, const Step &step);
  /// Adds -S of what the step knows beforehand of the springs' displacement, times their modulus
  /// [N].
  void add_past_stress(unsigned int region, const Step &step, DistributedVector &momentum);

  // Of the last step, at its balanced level.
  /// M dU/dt.
  void set_inertia(unsigned int region, const Step &step, DistributedVector &target);
  /// S U.
  void set_stiffness_of_velocity(unsigned int region, const Step &step, DistributedVector &target);
  /// S D.
  void set_stiffness(unsigned int region, const Step &step, DistributedVector &target);
  /// Whether B U of a step costs no product: its balanced level is the present one, of which the
  /// next step needs it, too.
  bool has_divergence(const unsigned int region, const Step &step) const
  {
    return has_step(region) && regions[region].wants_divergence && !step.extrapolate;
  }

private:
  enum Kind : unsigned int
  {
    mass_of_velocity,
    stiffness_of_velocity,
    stiffness_of_displacement,
    n_kinds
  };
  struct Level
  {
    std::array<DistributedVector, n_kinds> products;
    std::array<bool, n_kinds> is_known = {};
  };
  struct Region
  {
    Level present, older;
    DistributedVector past_inertia;
    DistributedVector divergence; ///< of the present level
    bool divergence_is_known = false;
    /// What a pass makes: what was asked for once is asked for in every step.
    std::array<bool, n_kinds> wants = {};
    bool wants_divergence = false;
  };

  const Problem &problem;
  Operators &operators;
  const BranchHistory &history;
  const DistributedVector &velocity, &velocity_older;
  std::vector<Region> regions;
  bool knows_step = false, is_shared = false;

  const DistributedVector &product(unsigned int region, Kind kind, bool of_older);
  /// Sets the product at the level that a step balances.
  void set_balanced(unsigned int region, Kind kind, const Step &step, DistributedVector &target);
};
} // namespace Continua

#endif
