#ifndef continua_continuum_newton_h
#define continua_continuum_newton_h

#include <continua/base/log.h>
#include <continua/continuum/boundary_pressures.h>
#include <continua/continuum/linear_system.h>
#include <continua/continuum/newton_input.h>
#include <continua/continuum/newton_residual.h>
#include <continua/continuum/nonlinear_system.h>
#include <continua/continuum/outlet_coupling.h>
#include <continua/continuum/problem.h>
#include <continua/continuum/products_by_region.h>
#include <continua/continuum/step_solution.h>
#include <continua/linear_algebra/block_krylov.h>
#include <continua/linear_algebra/distributed_vector.h>

namespace Continua
{
/**
 * Newton's iteration for the equations of a step that are not linear,
 *
 *   f - A U - G p - N_u(U, p) = 0,     g - B U - C p - N_p(U, p) = 0,
 *
 * (see NewtonResidual; NewtonConvergence judges the iterates) with the tangent's factor kept over
 * iterations and steps. When the residual falls too slowly, a new one is made, which is then the
 * exact derivative at that iterate; or the step goes on with GMRES and the exact derivative,
 * preconditioned with the kept factor, which is made anew when GMRES needs too many iterations. The
 * iteration ends when the residuals of momentum and of volume are small against the largest ones
 * met in the step, or at the round-off of the terms that cancel in them: a body at rest starts
 * there. In a body that comes to rest under a large pressure the round-off of that pressure remains
 * in the residual of volume. The iteration ends there, too: when momentum is at round-off, a
 * correction with the exact derivative has not halved the residual of volume, and what it leaves in
 * a step is below 1e-12 of the volume of each pressure. A volume or flow rate that is given must
 * be met to the same fraction.
 *
 * Outlets are linear. Each iteration solves without the forces of their ports and adds the body's
 * responses, as a linear step does. Given volumes of cavities and flow rates through sections are
 * equations of their own, whose unknowns are pressures; see BoundaryPressures. With outlets or
 * cavities a slow iteration makes a new factor, where the mesh stays.
 *
 * With explicit convection (Convection::treatment) the first iterate is part of the scheme: the
 * convective terms stay those that it has, and the tangent is that at rest, where they have no
 * derivative. The equations of the step are then linear, and the tangent serves all steps of one
 * size.
 */
class Newton
{
public:
  /// All must outlive it.
  Newton(const Problem &problem,
         NonlinearSystem &terms,
         LinearSystem &system,
         const ProductsByRegion &products,
         OutletCoupling &outlets,
         BoundaryPressures &unknown_pressures,
         Log &log);

  /// The mesh has changed; the vectors are those of the new one. Collective.
  void reinit(const DistributedVector &of_velocity, const DistributedVector &of_pressure);
  /// The next iteration makes a factor. Where a run writes a checkpoint it goes on as a restart
  /// from it would.
  void forget_factor() { has_factor = false; }
  /// In: in `solution` the prescribed velocities, a first guess of velocity and pressures, and for
  /// the acceleration the part of it that the past gives. Out: what balances the step; the
  /// acceleration is as before. Throws StepFailure.
  void solve(const NewtonInput &input, StepSolution &solution, StepReport &report);

private:
  const Problem &problem;
  NonlinearSystem &terms;
  LinearSystem &system;
  OutletCoupling &outlets;
  BoundaryPressures &unknown_pressures;
  Log &log;
  NewtonResidual residual;
  BlockKrylov krylov;
  bool has_factor = false;
  bool factor_is_poor = false; ///< GMRES needed too many iterations with it
  DistributedVector velocity_change, pressure_change, zero_velocity;
  StepSolution zero_state; ///< the state at rest, at which explicit convection has its tangent
  // Of the present step:
  unsigned int krylov_iterations = 0; ///< of GMRES
  bool may_take_krylov = false, takes_krylov = false;
  bool is_exact_at_once = false;    ///< GMRES from the first correction on
  bool correction_is_exact = false; ///< the last one had the exact derivative
  bool is_explicit = false;         ///< convection is that of the first iterate

  void begin_step(const NewtonInput &input, StepSolution &solution);
  /// Decides how an iterate is corrected, and makes a factor or keeps the derivative for it.
  void prepare_correction(const StepSolution &solution,
                          bool is_slow,
                          unsigned int iteration,
                          StepReport &report);
  /// Makes the factor of the tangent at an iterate, and finds what outlets and cavities do with it.
  void make_factor(const StepSolution &solution, unsigned int iteration, StepReport &report);
  /// Corrects an iterate. `scales`: sizes of the residuals.
  void correct(const NewtonInput &input,
               StepSolution &solution,
               const ResidualScales &scales,
               StepReport &report);
  /// Sets changes of velocity and pressure by GMRES; the right sides are restricted. `scales`:
  /// sizes in which it measures the residuals. Says whether it has reached its tolerance.
  bool solve_by_krylov(const NewtonInput &input,
                       const StepSolution &solution,
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
                         const StepSolution &solution,
                         const ResidualScales &scales,
                         StepReport &report);
};
} // namespace Continua

#endif
