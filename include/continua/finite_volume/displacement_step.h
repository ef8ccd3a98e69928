#ifndef continua_finite_volume_displacement_step_h
#define continua_finite_volume_displacement_step_h

#include <continua/continuum/step_solution.h>
#include <continua/finite_volume/cell_wise_loads.h>
#include <continua/finite_volume/cell_wise_system.h>
#include <continua/finite_volume/displacement_levels.h>

namespace Continua
{
/**
 * A step of the displacement form (equation 3.36): the displacement at the end of the step is the
 * unknown, and velocity and acceleration are differences of its levels.
 */
template <int dim>
class DisplacementStep
{
public:
  using Derivatives = DisplacementLevels::Derivatives;

  /// All must outlive it.
  DisplacementStep(const CellWiseSystem<dim> &system, const CellWiseLoads<dim> &loads);

  /// The mesh has changed.
  void reinit();
  CellWiseCoefficients coefficients(const Derivatives &derivatives) const;
  /// Makes the right-hand side; sets the acceleration and the prescribed velocities of `solution`,
  /// the acceleration as far as the levels before give it.
  void set_right_side(const Step &step,
                      const DisplacementLevels &levels,
                      const Derivatives &derivatives,
                      StepSolution &solution);
  /// Solves for the displacement, in which the solve starts from the present one; sets velocity and
  /// acceleration. Throws RunError.
  void solve(CellWiseSolve<dim> &cell_solve,
             const Derivatives &derivatives,
             DistributedVector &displacement,
             StepSolution &solution,
             StepReport &report);

private:
  const CellWiseSystem<dim> &system;
  const CellWiseLoads<dim> &loads;
  DistributedVector momentum, known_velocity, work, mass;
};
} // namespace Continua

#endif
