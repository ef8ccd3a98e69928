#ifndef continua_continuum_step_solution_h
#define continua_continuum_step_solution_h

#include <continua/linear_algebra/distributed_vector.h>
#include <continua/time_integration/step.h>

#include <vector>

namespace Continua
{
/// What a step has balanced, all at its balance time; owned vectors.
struct StepSolution
{
  Step step;
  DistributedVector velocity;     ///< [m/s]
  DistributedVector pressure;     ///< the unknown p [Pa]
  DistributedVector acceleration; ///< dU/dt as the scheme has it [m/s^2]
  DistributedVector
      pressure_rate; ///< dp/dt as the scheme has it, of steps that are not linear [Pa/s]
  DistributedVector displacement;         ///< with solids in finite deformation, else empty [m]
  DistributedVector mesh_displacement;    ///< of a mesh that moves, else empty [m]
  DistributedVector mesh_velocity;        ///< likewise [m/s]
  std::vector<double> boundary_pressures; ///< that are unknown [Pa]
  /// From which an explicit step has taken the convective terms, else empty [m/s].
  DistributedVector extrapolated_velocity;
  DistributedVector prescribed; ///< prescribed velocities where there are any, else 0 [m/s]
};
} // namespace Continua

#endif
