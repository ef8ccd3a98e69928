#ifndef continua_finite_volume_cell_wise_step_variant_h
#define continua_finite_volume_cell_wise_step_variant_h

#include <continua/base/log.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/step_variant.h>
#include <continua/finite_volume/cell_wise_linear_system.h>
#include <continua/finite_volume/cell_wise_loads.h>
#include <continua/finite_volume/cell_wise_products.h>
#include <continua/finite_volume/displacement_levels.h>
#include <continua/finite_volume/displacement_step.h>
#include <continua/finite_volume/excess_velocity.h>
#include <continua/finite_volume/loaded_faces.h>

#include <vector>

namespace Continua
{
/// What the cell-wise path does in a step in its own way: faces have no mass and deform at once,
/// Rhie and Chow's corrections act on the past, too, the displacement form solves for another
/// unknown, and the powers may be those that the thesis plots.
template <int dim>
class CellWiseStepVariant : public StepVariant
{
public:
  /// All must outlive it.
  CellWiseStepVariant(const Problem &problem,
                      const FaceConditions<dim> &conditions,
                      const CellWiseLoads<dim> &loads,
                      const std::vector<CellWiseOperators> &operators,
                      const PressureClosure &closure,
                      const CellWiseProducts<dim> &products,
                      CellWiseSystem<dim> &system,
                      CellWiseLinearSystem<dim> &linear_system,
                      ExcessVelocity<dim> &excess_velocity,
                      Log &log);

  /// The mesh has changed. Collective.
  void reinit();
  /// The mesh has moved. Collective.
  void take_shapes() { loaded_faces.reinit(); }

  /// With the pressure's own update, where one is asked for.
  Step adapted(const Step &step) override;
  void multiply_past_stiffness(unsigned int region,
                               DistributedVector &force,
                               const DistributedVector &mixture) override;
  void
  set_past_dilatation(unsigned int region, const State &start, DistributedVector &rate) override;
  bool corrects_fluxes() const override { return parameters.has_pressure(); }
  void add_past_flux_correction(const DistributedVector &pressure,
                                DistributedVector &mass) override;
  bool has_massless_velocities() const override;
  bool deform_at_once(DistributedVector &forces,
                      DistributedVector &displacement,
                      DistributedVector &pressure) override;
  bool has_pressure() const override { return parameters.has_pressure(); }
  void complete_pressure(const DistributedVector &displacement,
                         DistributedVector &pressure) override;
  bool solves_for_displacement() const override
  {
    return parameters.formulation == Formulation::displacement;
  }
  void make_displacement_step(const Step &step,
                              const DistributedVector &velocity,
                              DistributedVector &displacement,
                              StepSolution &solution,
                              StepReport &report) override;
  void set_reported_stress_force(unsigned int region,
                                 const StepSolution &step,
                                 DistributedVector &mixture,
                                 DistributedVector &force) override;
  bool reports_change_of_kinetic_energy() const override
  {
    return parameters.power_operator != PowerOperator::scheme;
  }

  // The state.
  void visit(StateVisitor &visitor);
  /// The state of t = 0 was set. Collective.
  void start_from(const State &state) { set_dilatation_rate(state); }
  /// A step has ended. Collective.
  void finish_step(const StepSolution &solution, const State &state);
  /// The flux corrections of a new mesh belong to the next step's equations.
  void forget_dilatation_rate() { dilatation_rate_is_current = false; }

  /// -K div D. Collective.
  void set_pressure_of_displacement(const DistributedVector &displacement,
                                    DistributedVector &pressure);

private:
  const Problem &problem;
  const CellWiseSpace<dim> &space;
  const CellWiseParameters &parameters;
  const std::vector<CellWiseOperators> &operators;
  const PressureClosure &closure;
  CellWiseSystem<dim> &system;
  CellWiseLinearSystem<dim> &linear_system;
  ExcessVelocity<dim> &excess_velocity;
  Log &log;
  LoadedFaces<dim> loaded_faces;
  DisplacementStep<dim> displacement_step; ///< of the displacement form
  Step present_step;                       ///< the one that is being made
  bool undamped_is_reported = false;

  // The state.
  /// div U as the equations of state have it, at the end of the last step, for the trapezoidal rule
  /// [m^3/s].
  DistributedVector dilatation_rate;
  bool dilatation_rate_is_current = true;
  DisplacementLevels displacement_levels;         ///< of the displacement form
  DistributedVector velocity_work, pressure_work; ///< work space

  void set_dilatation_rate(const State &state);
};
} // namespace Continua

#endif
