#ifndef continua_continuum_newton_residual_h
#define continua_continuum_newton_residual_h

#include <continua/continuum/linear_system.h>
#include <continua/continuum/newton_input.h>
#include <continua/continuum/nonlinear_system.h>
#include <continua/continuum/outlet_coupling.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/products_by_region.h>
#include <continua/continuum/step_solution.h>
#include <continua/continuum/system_coefficients.h>
#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/// Largest entries of the residuals of momentum [N] and of volume [m^3/s], and the round-off of the
/// terms that cancel in them.
struct ResidualNorms
{
  /// Of the terms that cancel, which a solve leaves [1].
  static constexpr double round_off = 1e-13;
  double momentum = 0., mass = 0.;
  double momentum_round_off = 0., mass_round_off = 0.;
};

/**
 * The residuals of the equations of a step that are not linear,
 *
 *   f - A U - G p - N_u(U, p),     g - B U - C p - N_p(U, p),
 *
 * and products with their derivative: by that of the terms, or by differences. In a step with
 * explicit convection N is that at the step's first iterate, and the kept derivative times the way
 * from there.
 */
class NewtonResidual
{
public:
  /// All must outlive it.
  NewtonResidual(const Problem &problem,
                 NonlinearSystem &terms,
                 LinearSystem &system,
                 const ProductsByRegion &products,
                 OutletCoupling &outlets);

  /// The mesh has changed; the vectors are those of the new one. Collective.
  void reinit(const DistributedVector &zero_velocity, const DistributedVector &zero_pressure);
  /// A step begins; `past`: the part of the acceleration that the past gives [m/s^2].
  void begin_step(const DistributedVector &past)
  {
    past_acceleration.equ(1., past);
    has_first = false;
  }
  /// That part.
  const DistributedVector &acceleration_of_past() const { return past_acceleration; }
  /// dU/dt and dp/dt of the iterate, and in finite deformation its displacement. Collective.
  void set_rates(const NewtonInput &input, StepSolution &solution) const;

  /// Sets the residuals, those without the forces of the ports and those with them, and returns the
  /// norms of the latter. `is_explicit`: the terms are those of the step's first iterate, and the
  /// kept derivative times the way from there. Collective.
  ResidualNorms
  set(const NewtonInput &input, const StepSolution &solution, bool is_explicit = false);
  /// What the residual of volume of the last set() leaves in a step, of the volume of each
  /// pressure: the largest part [1]. Collective.
  double lost_volume(const Step &step) const;

  /// The rows' derivative in the direction of changes of velocity and pressure, restricted; changes
  /// the residuals with the forces of the ports. Collective.
  void set_derivative_product(const NewtonInput &input,
                              const StepSolution &solution,
                              const DistributedVector &of_velocity,
                              const DistributedVector &of_pressure,
                              DistributedVector &momentum_rows,
                              DistributedVector &mass_rows);
  /// Leaves the rows that are equations; of ports that hold the flow rate on a mesh that moves
  /// their power with the port's profile. Collective.
  void restrict_rows(DistributedVector &momentum_rows, DistributedVector &mass_rows) const;
  /// Whether products with the tangent are differences of the terms that are not linear: on a mesh
  /// that moves nothing else has its motion in it.
  bool takes_differences() const;

  // Of the last set(); solvers may change them.
  DistributedVector momentum, mass;           ///< without the forces of the ports [N], [m^3/s]
  DistributedVector momentum_work, mass_work; ///< with them, restricted, until other products

private:
  const Problem &problem;
  NonlinearSystem &terms;
  LinearSystem &system;
  const ProductsByRegion &products;
  OutletCoupling &outlets;
  StepSolution shifted; ///< for differences
  DistributedVector past_acceleration;
  DistributedVector mesh_change; ///< by which differences shift the mesh [m]
  DistributedVector volumes;     ///< of each pressure [m^3]
  // Of a step with explicit convection: its first iterate, the terms there, and the way from there.
  bool has_first = false;
  DistributedVector first_velocity, first_pressure, first_momentum, first_mass;
  DistributedVector velocity_from_start, pressure_from_start;

  /// Takes A U + G p and B U + C p from the rows; raises the scales to the largest entries.
  void subtract_linear_terms(const SystemCoefficients &coefficients,
                             const DistributedVector &velocity,
                             const DistributedVector &pressure,
                             DistributedVector &momentum_rows,
                             DistributedVector &mass_rows,
                             ResidualScales &scales);
  /// Sets momentum_work and mass_work to the terms of an explicit step.
  void set_explicit_terms(const StepSolution &solution);
  /// The part of the terms that are not linear, by differences.
  void add_differences(const StepSolution &solution,
                       const DistributedVector &of_velocity,
                       const DistributedVector &of_pressure,
                       DistributedVector &momentum_rows,
                       DistributedVector &mass_rows);
};
} // namespace Continua

#endif
