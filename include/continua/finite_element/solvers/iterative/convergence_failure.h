#ifndef continua_finite_element_solvers_iterative_convergence_failure_h
#define continua_finite_element_solvers_iterative_convergence_failure_h

#include <continua/finite_element/conditions/boundary_constraints.h>
#include <continua/finite_element/solvers/iterative/step_preconditioner.h>
#include <continua/finite_element/solvers/stalled_block.h>
#include <continua/finite_element/space/linear_solver_parameters.h>
#include <continua/finite_element/space/space.h>
#include <continua/linear_algebra/saddle_point_solver.h>

#include <string>

namespace Continua
{
/// Measures each block of the preconditioner alone, with the velocities' block of the matrix that
/// was to be solved, names the one that stalls, and says what to do. Takes as long as 40
/// iterations. `report`: of the solve that has not converged. Collective.
template <int dim>
std::string describe_convergence_failure(const Space<dim> &space,
                                         const BoundaryConstraints<dim> &constraints,
                                         const LinearSolverParameters &parameters,
                                         const SaddlePointSolver::Blocks &system,
                                         StepPreconditioner<dim> &used,
                                         TangentTerms kind,
                                         const KrylovReport &report);
} // namespace Continua

#endif
