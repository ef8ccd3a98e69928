#ifndef continua_case_tangent_checks_h
#define continua_case_tangent_checks_h

#include <continua/base/parameter_section.h>
#include <continua/finite_element/space/linear_solver_parameters.h>

namespace Continua
{
/// Refuses entries of which a run whose steps are iterated (Convection = navier stokes or
/// Deformation = finite) makes no use. Throws InputError.
void refuse_what_tangents_leave_idle(LinearSolverType type, ParameterSection root);
} // namespace Continua

#endif
