#ifndef continua_continuum_time_stepping_h
#define continua_continuum_time_stepping_h

#include <continua/base/archive.h>
#include <continua/base/log.h>
#include <continua/continuum/branch_history.h>
#include <continua/continuum/bulk_history.h>
#include <continua/continuum/kept_state.h>
#include <continua/continuum/ledger.h>
#include <continua/continuum/level_products.h>
#include <continua/continuum/newton.h>
#include <continua/continuum/operators.h>
#include <continua/continuum/outlet_coupling.h>
#include <continua/continuum/problem.h>
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
  bool steady_is_direct() const;
  /// One solve without time, loads taken at `time` [s]: the displacement of a solid at rest, the
  /// velocity of a steady flow. Throws RunError.
  void solve_steady(double time);

  /// See ContinuumSolver.
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
    return ledger.forces_at_nodes({solution, velocity_older, velocity}, region);
  }

  /// Call when cells are flagged and before the triangulation changes, and after.
  void prepare_refinement();
  void transfer();
  void save(ArchiveWriter &archive) const;
  void load(const ArchiveReader &archive);

  /// The state at the present time, to be read.
  State state();
  double time() const { return present_time; }
  /// The pressures of the outlets' ports at the present time, by boundary condition [Pa].
  std::vector<double> port_pressures() { return outlets.present_pressures(present_time, velocity); }
  /// Call before others than the steps change the state, as shapes of vibration do.
  void share_state() { products.share(); }
  DistributedVector &present_velocity() { return velocity; }
  DistributedVector &present_displacement() { return history.displacement(); }
  DistributedVector &present_pressure() { return pressure; }
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
  LevelProducts products;
  Ledger ledger;

  // The state: at the present time, and one step before.
  DistributedVector velocity, velocity_older, pressure, pressure_older;
  double present_time = 0.;
  std::vector<DistributedVector> mixtures; ///< by region, of a harmonic motion alone
  StepSolution solution;                   ///< by the last step
  DistributedVector prescribed;            ///< velocities, constants set once [m/s]
  // The last pressure known at a time of its own, from which that of an incompressible material is
  // extrapolated.
  DistributedVector pressure_known;
  double pressure_known_time = 0.;
  std::vector<unsigned int> pressures_without_history; ///< local indices
  bool some_pressures_without_history = false;         ///< on any rank
  /// Relaxation times whose exponential update the log has told of.
  std::set<double> exponential_branches_reported;
  // Work space of the step.
  /// Of the step before, and what of them linear products have.
  SystemCoefficients equation_coefficients, coefficients;
  DistributedVector momentum, mass, velocity_work, mixture, pressure_work, mass_work;

  KeptState kept;

  void setup();
  /// The list of the state: what is added here is saved, kept, given back and carried over.
  void visit(StateVisitor &visitor);
  State present() const
  {
    return State{velocity,
                 pressure,
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
  /// Of the velocity nodes of this rank: whether a solid has them.
  std::vector<bool> nodes_of_solids() const;
  void report_exponential_branches(const Step &step);
  /// StepReport::steady_change of a step that is solved and not finished.
  double steady_change(const Step &step);
  /// Solves the equations of a step at its balanced level.
  void balance(const Step &step, StepReport &report);
  /// The same by Newton's iteration, of the right-hand sides that are set.
  void iterate(const Step &step, bool system_is_new, StepReport &report);
  /// Whether the linear system and the right-hand sides have nothing of a region but its supports
  /// and loads.
  bool has_all_terms_in(const unsigned int region) const
  {
    return operators.has_all_terms_in(region);
  }
  /// Sets balanced.velocity to the velocity at the level that a step balances, extrapolated from
  /// the last two levels.
  void extrapolate_velocity(const Step &step);
  /// Sets the first guess of the velocity [m/s] of solids in finite deformation to zero.
  void stop_finite_solids(DistributedVector &of_velocity) const;
  /// The parts of a step: its system, its right-hand sides, and the state at its end.
  SystemChange prepare(const Step &step, StepReport &report);
  void set_momentum(const Step &step);
  void set_mass(const Step &step);
  void set_prescribed(const Step &step);
  void finish(const Step &step);
  void extrapolate_pressure(const Step &step);
  /// Velocities without mass deform by the forces that are out of balance at this time: at the
  /// start, where the load is there at once, and on a new mesh.
  void deform_by_imbalance(double time);
  /// They deform by a load that jumps in the step, where the rule is trapezoidal.
  void deform_by_jump(const Step &step);
  /// They deform by the forces in `momentum`.
  void deform_massless();
};
} // namespace Continua

#endif
