#ifndef continua_continuum_step_extremes_h
#define continua_continuum_step_extremes_h

#include <continua/continuum/continuum_solver.h>
#include <continua/linear_algebra/distributed_vector.h>
#include <continua/time_integration/step.h>

#include <mpi.h>

#include <string>

namespace Continua
{
/// Sets the report's largest velocity, and its largest change from the step's start, of a step that
/// is solved but not finished: `at_level` and `pressure` are its solution. Throws RunError if that
/// is not finite. Collective.
void set_extremes(const Step &step,
                  const DistributedVector &start,
                  const DistributedVector &at_level,
                  const DistributedVector &pressure,
                  StepReport &report);

/// "; " and the first expression, of all ranks, that had a value which is not finite; empty if
/// there is none: the likely reason for a solution that is not finite. Collective.
std::string reason_not_finite(MPI_Comm communicator);
} // namespace Continua

#endif
