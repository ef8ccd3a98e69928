#ifndef continua_continuum_equation_term_h
#define continua_continuum_equation_term_h

#include <continua/continuum/bulk_history.h>
#include <continua/continuum/level_products.h>
#include <continua/continuum/operators.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state.h>
#include <continua/continuum/step_solution.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Continua
{
/// What the terms of the equations are made of, and work space for them.
struct TermContext
{
  const Problem &problem;
  Operators &operators;
  const BranchHistory &history;
  const BulkHistory &bulk_history;
  LevelProducts *products = nullptr; ///< of the state; null where they are not kept
  DistributedVector force = {}, mixture = {}, forgotten = {}; ///< like velocities
  DistributedVector dilatation = {}, forgotten_rate = {};     ///< like pressures
  /// Of the region at hand: the powers of a step that is over, and the energies of a state.
  NonlinearPowers nonlinear_powers = {};
  NonlinearEnergy nonlinear_energy = {};

  /// Whether the powers of a region are the nonlinear ones alone, without products with matrices.
  bool has_all_terms_in(const unsigned int region) const
  {
    return operators.has_all_terms_in(region);
  }
  /// Whether products of the state's levels are those of the region.
  bool has_products(const unsigned int region) const
  {
    return products != nullptr && products->has(region);
  }
  /// Whether they are those of the step that is over, too.
  bool has_products_of_step(const unsigned int region) const
  {
    return products != nullptr && products->has_step(region);
  }
};

/// A step that is over: what it has balanced, and the velocities at its ends [m/s].
struct FinishedStep
{
  const StepSolution &solution;
  const DistributedVector &start, &end;
};

/// A term of the equations of motion and state, as the ledger sees it. All numbers are this rank's
/// part.
class EquationTerm
{
public:
  virtual ~EquationTerm() = default;
  /// The power that the term takes in a region [W], by the scheme's own operators at the level at
  /// which the step balances. Adds the forces behind it to `forces` [N] unless that is null, but
  /// for those behind the nonlinear powers, which the ledger adds.
  virtual double power(unsigned int region,
                       const FinishedStep &step,
                       TermContext &context,
                       DistributedVector *forces) const = 0;
  /// The part of the power that relaxation turns into heat [W], at the cost of a product for each
  /// branch that relaxes.
  virtual double relaxation_power(unsigned int, const StepSolution &, TermContext &) const
  {
    return 0.;
  }
  /// The energy that the term holds in a region at the present time [J].
  virtual double energy(unsigned int, const State &, TermContext &) const { return 0.; }
};

/// A row of the table of terms.
struct EquationTermType
{
  std::string name;  ///< "kinetic": of the columns "kinetic [W]", "kinetic energy [J]"
  std::string total; ///< of the power over the whole run: "kinetic energy taken"
  bool stores;       ///< whether it holds energy
  bool may_relax;    ///< whether relaxation may turn a part of its power into heat
  std::function<std::unique_ptr<EquationTerm>()> make;
};

/// The terms of the equations of a problem, in the order of the ledger's columns: a row here gives
/// `power.csv` and the summary what they say of the term. Only runs with convection and bodies with
/// supports have theirs.
std::vector<EquationTermType> equation_terms(const Problem &problem);
} // namespace Continua

#endif
