#ifndef continua_continuum_step_extremes_h
#define continua_continuum_step_extremes_h

#include <continua/continuum/continuum_solver.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/time_integration/step.h>

namespace Continua
{
/// Sets the report's largest velocity, and its largest change from the step's start, of a step that
/// is solved but not finished: `balanced` and `pressure` are its solution. Throws RunError if that
/// is not finite. Collective.
void set_extremes(const Step &step,
                  const DistributedVector &start,
                  const DistributedVector &balanced,
                  const DistributedVector &pressure,
                  StepReport &report);
} // namespace Continua

#endif
