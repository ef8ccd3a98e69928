#ifndef continua_continuum_time_stepping_h
#define continua_continuum_time_stepping_h

#include <continua/base/archive.h>
#include <continua/base/log.h>
#include <continua/continuum/branch_history.h>
#include <continua/continuum/bulk_history.h>
#include <continua/continuum/kept_state.h>
#include <continua/continuum/known_pressure.h>
#include <continua/continuum/ledger.h>
#include <continua/continuum/level_products.h>
#include <continua/continuum/massless_motion.h>
#include <continua/continuum/newton.h>
#include <continua/continuum/operators.h>
#include <continua/continuum/outlet_coupling.h>
#include <continua/continuum/prepared_system.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/solid_nodes.h>
#include <continua/continuum/state_levels.h>
#include <continua/continuum/steady_change.h>
#include <continua/continuum/steady_solve.h>
#include <continua/continuum/step_right_side.h>
#include <continua/continuum/wall_shear_average.h>

#include <optional>
#include <set>
#include <vector>

namespace Continua
{
/**
 * The state of the continuum and the step that changes it, written once for every discretisation:
 * the levels of velocity and pressure, the histories of the branches, the outlets, and what a
 * scheme does with them. A discretisation gives the operators. See the chapter on the numerics in
 * the manual.
 */
class TimeStepping
{
public:
  /// All must outlive it.
  TimeStepping(const Problem &problem, Operators &operators, Log &log);

  /// Sets everything up on the present mesh, with the state of t = 0.
  void initialise();
  /// See ContinuumSolver. Materials without branches have no displacement then.
  void stop_solids();
  void start_from_present_state();
  void begin_unloaded_shape();
  void keep_unloaded_shape();
  /// One step; throws RunError if the result is not finite or the solve failed.
  StepReport advance(const Step &step);
  /// Whether solve_steady() applies: the body is all solid or all fluid.
  bool steady_is_direct() const { return steady_solve.applies(); }
  /// One solve without time, loads taken at `time` [s]: the displacement of a solid at rest, the
  /// velocity of a steady flow. Throws RunError.
  void solve_steady(double time);

  /// See ContinuumSolver.
  void begin_averages() { wall_shear.start(present()); }
  void add_to_averages(double duration);
  StepError step_error();
  void keep_state();
  void return_to_kept_state();
  bool data_jumps(double begin, double end) const;

  const Network *network() { return outlets.network(); }
  PowerBalance power_balance(bool relaxation);
  Energy energy();
  /// Call before the first step if forces_at_nodes() will be asked for, of the body and of these
  /// regions.
  void want_forces_at_nodes(const std::set<unsigned int> &regions) { ledger.want_forces(regions); }
  /// Of the last step at the time at which it balances, or of the steady solution; see Ledger.
  const DistributedVector &forces_at_nodes(const std::optional<unsigned int> region)
  {
    return ledger.forces_at_nodes({solution, levels.velocity_older, levels.velocity}, region);
  }

  /// Call when cells are flagged and before the triangulation changes, and after.
  void prepare_refinement();
  void transfer();
  void save(ArchiveWriter &archive) const;
  void load(const ArchiveReader &archive);

  /// The state at the present time, to be read.
  State state();
  double time() const { return present_time; }
  /// The time of the loads that the last step has balanced [s]; of a state at rest its own.
  double time_of_loads() const { return solution.step.balance_time; }
  /// The pressures of the outlets' ports at the present time, by boundary condition [Pa].
  std::vector<double> port_pressures()
  {
    return outlets.present_pressures(present_time, levels.velocity);
  }
  /// Call before others than the steps change the state, as shapes of vibration do.
  void share_state() { products.share(); }
  DistributedVector &present_velocity() { return levels.velocity; }
  DistributedVector &present_displacement() { return history.displacement(); }
  DistributedVector &present_pressure() { return levels.pressure; }
  /// Of a harmonic motion, see State::mixtures; empty until it sets them.
  std::vector<DistributedVector> &present_mixtures() { return mixtures; }

private:
  const Problem &problem;
  Operators &operators;
  Log &log;
  BranchHistory history;
  BulkHistory bulk_history;
  OutletCoupling outlets;
  BoundaryPressures unknown_pressures;
  WallShearAverage wall_shear;
  /// None where all terms are linear. Its factor is no part of the state: a checkpoint makes it
  /// forgotten.
  mutable std::optional<Newton> newton;
  StateLevels levels;
  LevelProducts products;
  StepRightSide right_side;
  MasslessMotion massless_motion;
  PreparedSystem system;
  KnownPressure known_pressure;
  SteadyChange steady_change;
  SolidNodes solid_nodes;
  SteadySolve steady_solve;
  Ledger ledger;
  double present_time = 0.;
  std::vector<DistributedVector> mixtures;  ///< by region, of a harmonic motion alone
  StepSolution solution;                    ///< of the last step
  DistributedVector velocity_work, product; ///< work space

  KeptState kept;

  void setup();
  /// The list of the state: what is added here is saved, kept, given back and carried over.
  void visit(StateVisitor &visitor);
  State present() const
  {
    return State{levels.velocity,
                 levels.pressure,
                 history,
                 wall_shear.is_on() ? &wall_shear : nullptr,
                 operators.wall_potentials(),
                 operators.unloaded_displacement(),
                 &unknown_pressures.states(),
                 operators.mesh_displacement(),
                 mixtures.empty() ? nullptr : &mixtures};
  }
  /// Where a run writes a checkpoint or begins anew it goes on as a restart would.
  void forget_linearisation() const;
  /// Solves the equations of a step at its balanced level.
  void balance(const Step &step, StepReport &report);
  /// The same by Newton's iteration, of the right-hand sides that are set.
  void iterate(const Step &step, bool system_is_new, StepReport &report);
  /// Sets the state at the end of a step that is solved.
  void finish(const Step &step);
};
} // namespace Continua

#endif
