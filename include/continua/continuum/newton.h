#ifndef continua_continuum_newton_h
#define continua_continuum_newton_h

#include <continua/base/log.h>
#include <continua/continuum/balanced_step.h>
#include <continua/continuum/cavity_coupling.h>
#include <continua/continuum/operators.h>
#include <continua/continuum/outlet_coupling.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/system_coefficients.h>
#include <continua/linear_algebra/block_krylov.h>

namespace Continua
{
/// What Newton's iteration of a step starts from.
struct NewtonInput
{
  const Step &step;
  const SystemCoefficients &coefficients;
  bool system_is_new;                ///< the coefficients are others than those of the step before
  const DistributedVector &momentum; ///< f of the linear equations [N]
  const DistributedVector &mass;     ///< g of them [m^3/s]
  const DistributedVector &predicted_pressure; ///< p_plus [Pa]
  const DistributedVector &velocity_old;       ///< at the step's start [m/s]
  /// D_plus of the displacement with Deformation::finite, else unused [m].
  const DistributedVector &predicted_displacement;
};

/**
 * Newton's iteration for the equations of a step that are not linear,
 *
 *   f - A U - G p - N_u(U, p) = 0,     g - B U - C p - N_p(U, p) = 0,
 *
 * with the tangent's factor kept over iterations and steps. When the residual falls too slowly, a
 * new one is made, which is then the exact derivative at that iterate; or the step goes on with
 * GMRES and the exact derivative, preconditioned with the kept factor, which is made anew when
 * GMRES needs too many iterations. The iteration ends when the
 * residuals of momentum and of volume are small against the largest ones met in the step, or at the
 * round-off of the terms that cancel in them: a body at rest starts there. In a body that comes to
 * rest under a large pressure the round-off of that pressure remains in the residual of volume. The
 * iteration ends there, too: when momentum is at round-off, a correction with the exact derivative
 * has not halved the residual of volume, and what it leaves in a step is below 1e-12 of the volume
 * of each pressure. The volume of a cavity must differ from the one given by the same fraction at
 * most.
 *
 * Outlets are linear. Each iteration solves without the forces of their ports and adds the body's
 * responses, as a linear step does. The volumes of cavities are equations of their own, whose
 * unknowns are the cavities' pressures; see CavityCoupling. With outlets or cavities a slow
 * iteration makes a new factor, where the mesh stays.
 */
class Newton
{
public:
  /// All must outlive it.
  Newton(const Problem &problem,
         Operators &operators,
         OutletCoupling &outlets,
         CavityCoupling &cavities,
         Log &log);

  /// The mesh has changed.
  void reinit();
  /// The next iteration makes a factor. Where a run writes a checkpoint it goes on as a restart
  /// from it would.
  void forget_factor() { has_factor = false; }
  /// In: in `balanced` the prescribed velocities, a first guess of velocity and pressures, and for
  /// the acceleration the part of it that the past gives. Out: what balances the step; the
  /// acceleration is as before. Throws StepFailure.
  void solve(const NewtonInput &input, BalancedStep &balanced, StepReport &report);

private:
  /// Largest entries of the residuals of momentum and of volume, and the round-off of the terms
  /// that cancel in them.
  struct Norms
  {
    double momentum = 0., mass = 0.;
    double momentum_round_off = 0., mass_round_off = 0.;
  };

  const Problem &problem;
  Operators &operators;
  OutletCoupling &outlets;
  CavityCoupling &cavities;
  Log &log;
  BlockKrylov krylov;
  bool has_factor = false;
  bool factor_is_poor = false;        ///< GMRES needed too many iterations with it
  unsigned int krylov_iterations = 0; ///< of GMRES in the step
  BalancedStep shifted;               ///< for differences
  DistributedVector past_acceleration, momentum, momentum_work, velocity_change, zero_velocity;
  DistributedVector mesh_change; ///< by which differences shift the mesh [m]
  DistributedVector mass, mass_work, pressure_change;
  DistributedVector volumes; ///< of each pressure [m^3]

  /// dU/dt and dp/dt of the iterate, and in finite deformation its displacement.
  void set_rates(const NewtonInput &input, BalancedStep &balanced) const;
  /// Takes A U + G p and B U + C p from the rows; raises the scales to the largest entries.
  void subtract_linear_terms(const SystemCoefficients &coefficients,
                             const DistributedVector &velocity,
                             const DistributedVector &pressure,
                             DistributedVector &momentum_rows,
                             DistributedVector &mass_rows,
                             ResidualScales &scales);
  /// The rows' derivative in the direction of changes of velocity and pressure, restricted.
  void set_derivative_product(const NewtonInput &input,
                              const BalancedStep &balanced,
                              const DistributedVector &of_velocity,
                              const DistributedVector &of_pressure,
                              DistributedVector &momentum_rows,
                              DistributedVector &mass_rows);
  /// Leaves the rows that are equations; of ports that hold the flow rate on a mesh that moves
  /// their power with the port's profile.
  void restrict_rows(DistributedVector &momentum_rows, DistributedVector &mass_rows) const;
  /// Whether products with the tangent are differences of the terms that are not linear: on a mesh
  /// that moves nothing else has its motion in it.
  bool takes_differences() const;
  /// The part of the terms that are not linear, by differences.
  void add_differences(const BalancedStep &balanced,
                       const DistributedVector &of_velocity,
                       const DistributedVector &of_pressure,
                       DistributedVector &momentum_rows,
                       DistributedVector &mass_rows);
  /// What the residual in mass_work leaves in a step, of the volume of each pressure: the largest
  /// part [1]. Collective.
  double lost_volume(const Step &step) const;
  /// Sets changes of velocity and pressure by GMRES; the right sides are restricted. `scales`:
  /// sizes in which it measures the residuals. Says whether it has reached its tolerance.
  bool solve_by_krylov(const NewtonInput &input,
                       const BalancedStep &balanced,
                       const ResidualScales &scales,
                       DistributedVector &momentum_rows,
                       DistributedVector &mass_rows,
                       DistributedVector &of_velocity,
                       DistributedVector &of_pressure,
                       StepReport &report);
  /// The same by the factor, and of a mesh that moves with what outlets do. The right sides are
  /// changed.
  void solve_by_factor(DistributedVector &momentum_rows,
                       DistributedVector &mass_rows,
                       DistributedVector &of_velocity,
                       DistributedVector &of_pressure,
                       StepReport &report);
  /// Sets the correction of an iterate from its residuals, and what cavities need for theirs. Says
  /// whether it has the exact derivative.
  bool correct_by_krylov(const NewtonInput &input,
                         const BalancedStep &balanced,
                         const ResidualScales &scales,
                         StepReport &report);
  /// Sets `momentum` and `mass` to the residuals without the forces of the ports, and returns those
  /// with them.
  Norms set_residuals(const NewtonInput &input, const BalancedStep &balanced);
};
} // namespace Continua

#endif
