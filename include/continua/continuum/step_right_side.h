#ifndef continua_continuum_step_right_side_h
#define continua_continuum_step_right_side_h

#include <continua/continuum/branch_history.h>
#include <continua/continuum/bulk_history.h>
#include <continua/continuum/level_products.h>
#include <continua/continuum/operators.h>
#include <continua/continuum/outlet_coupling.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/state_levels.h>
#include <continua/continuum/step_solution.h>
#include <continua/continuum/system_coefficients.h>

namespace Continua
{
/**
 * The right-hand sides of the equations of a step: what the past, the loads and the prescribed
 * velocities give. Regions whose terms are not linear have nothing here but supports and loads, see
 * Operators::has_all_terms_in().
 */
class StepRightSide
{
public:
  /// All must outlive it.
  StepRightSide(const Problem &problem,
                Operators &operators,
                const BranchHistory &history,
                BulkHistory &bulk_history,
                OutletCoupling &outlets,
                LevelProducts &products,
                const StateLevels &levels);

  /// The mesh has changed; zeros of its vectors.
  void reinit(const DistributedVector &zero_velocity, const DistributedVector &zero_pressure);
  /// Sets both rows of a step from the state `present`, and in `solution` the prescribed velocities
  /// and what the acceleration has of the past.
  void set(const Step &step,
           const SystemCoefficients &coefficients,
           const State &present,
           StepSolution &solution);

  DistributedVector &momentum() { return momentum_rows; } ///< [N]
  DistributedVector &mass() { return mass_rows; }         ///< [m^3/s]
  /// What the step knows of the pressure beforehand [Pa].
  const DistributedVector &past_pressure() const { return pressure_work; }
  /// The prescribed velocities at a time [m/s]. Those that do not depend on time are set once on a
  /// mesh, so that all ask here.
  const DistributedVector &prescribed_at(double time);

private:
  const Problem &problem;
  Operators &operators;
  const BranchHistory &history;
  BulkHistory &bulk_history;
  OutletCoupling &outlets;
  LevelProducts &products;
  const StateLevels &levels;
  DistributedVector momentum_rows, mass_rows;
  DistributedVector prescribed; ///< velocities, constants set once [m/s]
  // Work space.
  DistributedVector velocity_work, velocity_product, mixture;
  DistributedVector pressure_work, pressure_product, relaxed_pressure;

  void set_momentum(const Step &step, DistributedVector &acceleration);
  /// Adds -S D of the supports' springs, as far as the step knows D beforehand.
  void add_supports(const Step &step);
  void add_loads(const Step &step);
  void set_mass(const Step &step, const SystemCoefficients &coefficients, const State &present);
  void set_prescribed(const Step &step, DistributedVector &of_step);
};
} // namespace Continua

#endif
